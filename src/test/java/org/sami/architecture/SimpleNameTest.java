package org.sami.architecture;

import static java.util.stream.Collectors.groupingBy;
import static java.util.stream.Collectors.mapping;
import static java.util.stream.Collectors.toCollection;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaModifier;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** No two classes have one simple name where a third may import both: a reader would have to look at the imports. */
class SimpleNameTest {
    /** Pairs that stay: each is its side's own word, and no class has a use for both. */
    private static final Map<String, Set<String>> KNOWN = Map.of(
            "Candidate", Set.of("org.sami.crw.service.allocation", "org.sami.spn.component"),
            "Telemetry", Set.of("org.sami.boat.link", "org.sami.spn.journal"));

    @Test
    void noSimpleNameStandsForTwoPublicClasses() {
        List<JavaClass> classes = SamiModule.built()
                .flatMap(module -> module.classes().stream())
                .filter(type -> type.isTopLevelClass() && type.getModifiers().contains(JavaModifier.PUBLIC))
                .toList();

        Map<String, SortedSet<String>> packages = classes.stream()
                .collect(groupingBy(
                        JavaClass::getSimpleName,
                        TreeMap::new,
                        mapping(JavaClass::getPackageName, toCollection(TreeSet::new))));
        packages.values().removeIf(all -> all.size() < 2);

        assertThat(classes).hasSizeGreaterThan(400);
        assertThat(packages).isEqualTo(KNOWN);
    }
}
