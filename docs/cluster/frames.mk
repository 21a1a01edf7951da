# make -j 4 -f frames.mk TRAJECTORY=traj.xyz PARTS=16 [film.mp4]
# All parts run each time: what is there and as it would be made is passed over. -k goes on where one fails.
TRAJECTORY ?= traj.xyz
PARTS ?= 4
SPHEREVIEW ?= sphereview
export SPHEREVIEW

parts = $(shell seq $(PARTS))
stamps = $(patsubst %,frames/part-%.done,$(parts))

frames/verified: $(stamps)
	$(SPHEREVIEW) verify --sample 1% $(patsubst %,frames/part-%.jsonl,$(parts))
	touch $@

# A stamp becomes new where the part's manifest has changed, so that nothing else is verified and filmed once more.
frames/part-%.done: always
	sh ./part.sh $(TRAJECTORY) $* $(PARTS)
	cmp -s frames/part-$*.jsonl $@ || cp frames/part-$*.jsonl $@

film.mp4: frames/verified
	sh ./film.sh $(TRAJECTORY) $@

.PHONY: always
