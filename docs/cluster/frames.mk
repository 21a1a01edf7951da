# make -j 4 -f frames.mk TRAJECTORY=traj.xyz PARTS=16 [film.mp4]
# A part that failed leaves no stamp: the same command runs it again. -k goes on with the others.
TRAJECTORY ?= traj.xyz
PARTS ?= 4
SPHEREVIEW ?= sphereview
export SPHEREVIEW

stamps = $(patsubst %,frames/part-%.done,$(shell seq $(PARTS)))

frames/verified: $(stamps)
	$(SPHEREVIEW) verify --sample 1% frames/part-*.jsonl
	touch $@

frames/part-%.done: $(TRAJECTORY) | frames
	sh ./part.sh $(TRAJECTORY) $* $(PARTS)
	touch $@

frames:
	mkdir -p $@

film.mp4: frames/verified
	sh ./film.sh $@
