package raytracing.compiled;

final class HierarchyWalk {
}
