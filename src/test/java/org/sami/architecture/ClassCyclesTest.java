package org.sami.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/**
 * Classes that depend on each other in a ring cannot be read, tested or moved one by one. The limits here stand just above what was counted last (46 in
 * 9 rings): they may only fall. Nested classes count with their outermost class.
 */
class ClassCyclesTest {
    private static final int MOST_CLASSES_IN_RINGS = 50;
    private static final int LARGEST_RING = 10;

    private static final int LEAST_CLASSES = 1900;

    @Test
    void ringsOfClassesBecomeFewerAndSmaller() {
        Map<String, Set<String>> known = dependencies();
        List<Set<String>> rings = new Rings(known).find();

        assertThat(known).hasSizeGreaterThan(LEAST_CLASSES);
        assertThat(rings.get(0)).as("the largest ring").hasSizeLessThanOrEqualTo(LARGEST_RING);
        assertThat(rings.stream().mapToInt(Set::size).sum())
                .as(() -> "classes in rings: " + rings)
                .isLessThanOrEqualTo(MOST_CLASSES_IN_RINGS);
    }

    @Test
    void ringsAreFoundWithTheirMembersAndNoOthers() {
        Map<String, Set<String>> known = Map.of(
                "a",
                Set.of("b"),
                "b",
                Set.of("c"),
                "c",
                Set.of("a", "d"),
                "d",
                Set.of("e"),
                "e",
                Set.of("d"),
                "f",
                Set.of("a"));

        assertThat(new Rings(new TreeMap<>(known)).find()).containsExactly(Set.of("a", "b", "c"), Set.of("d", "e"));
    }

    /** The other classes of the project that each class uses. */
    private static Map<String, Set<String>> dependencies() {
        Map<String, Set<String>> known = new TreeMap<>();
        SamiModule.built()
                .flatMap(module -> module.classes().stream())
                .forEach(type -> known.computeIfAbsent(outermost(type), name -> new TreeSet<>())
                        .addAll(used(type)));
        known.values().forEach(used -> used.retainAll(known.keySet()));
        return known;
    }

    private static Set<String> used(JavaClass type) {
        Set<String> used = new TreeSet<>();
        for (Dependency dependency : type.getDirectDependenciesFromSelf()) {
            used.add(outermost(dependency.getTargetClass().getBaseComponentType()));
        }
        used.remove(outermost(type));
        return used;
    }

    private static String outermost(JavaClass type) {
        int nested = type.getName().indexOf('$');
        return nested < 0 ? type.getName() : type.getName().substring(0, nested);
    }

    /** Finds the strongly connected components of more than one class (R. Tarjan, Depth-first search and linear graph algorithms, 1972). */
    private static final class Rings {
        private final Map<String, Set<String>> known;
        private final Map<String, Integer> numbers = new HashMap<>();
        private final Map<String, Integer> lowest = new HashMap<>();
        private final Deque<String> path = new ArrayDeque<>();
        private final List<Set<String>> found = new ArrayList<>();

        Rings(Map<String, Set<String>> known) {
            this.known = known;
        }

        /** The rings, the largest first. */
        List<Set<String>> find() {
            known.keySet().stream().filter(name -> !numbers.containsKey(name)).forEach(this::visit);
            found.sort(
                    Comparator.comparingInt((Set<String> ring) -> ring.size()).reversed());
            return found;
        }

        private void visit(String name) {
            int number = numbers.size();
            numbers.put(name, number);
            lowest.put(name, number);
            path.push(name);
            for (String used : known.get(name)) {
                if (!numbers.containsKey(used)) {
                    visit(used);
                    lowest.merge(name, lowest.get(used), Math::min);
                } else if (path.contains(used)) {
                    lowest.merge(name, numbers.get(used), Math::min);
                }
            }
            if (lowest.get(name) == number) {
                Set<String> ring = new TreeSet<>();
                while (numbers.get(path.peek()) > number) {
                    ring.add(path.pop());
                }
                ring.add(path.pop());
                if (ring.size() > 1) {
                    found.add(ring);
                }
            }
        }
    }
}
