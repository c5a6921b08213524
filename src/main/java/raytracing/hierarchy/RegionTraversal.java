package raytracing.hierarchy;

/** Finds the leaves of a hierarchy whose boxes may reach into a region, in no useful order. */
abstract class RegionTraversal extends Traversal {
    /** Goes on to the next leaf whose box may reach into the region; returns whether there is one. */
    public final boolean nextLeaf() {
        int count = waitingCount;
        while (count > 0) {
            count--;
            int node = waiting[count];
            if (!isOutside(Bounds.STRIDE * node)) {
                int link = links[node];
                if (link < 0) {
                    setLeaf(link);
                    waitingCount = count;
                    return true;
                }
                waiting[count] = node + link + 1;
                waiting[count + 1] = node + link;
                count += 2;
            }
        }
        waitingCount = 0;
        return false;
    }

    /** Whether a box, given by where its numbers begin, is certainly outside the region. */
    abstract boolean isOutside(int box);
}
