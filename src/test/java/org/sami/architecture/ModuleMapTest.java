package org.sami.architecture;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClasses;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Holds the modules to the map. Every rule first makes sure that it saw the classes it speaks of. */
class ModuleMapTest {
    /** Raised as SAMI grows, like the numbers of the modules. */
    private static final int LEAST_CLASSES_OF_ALL = 360;

    @ParameterizedTest
    @EnumSource(SamiModule.class)
    void keepsToItsOwnPackages(SamiModule module) {
        JavaClasses classes = seen(module);

        classes().should().resideInAnyPackage(module.packages()).check(classes);
    }

    @ParameterizedTest
    @EnumSource(SamiModule.class)
    void knowsOnlyTheModulesOfTheMap(SamiModule module) {
        JavaClasses classes = seen(module);

        noClasses()
                .should()
                .dependOnClassesThat(
                        resideInAPackage("org.sami..").and(not(resideInAnyPackage(module.knownPackages()))))
                .check(classes);
    }

    @ParameterizedTest
    @EnumSource(SamiModule.class)
    void hasNoCyclesOfPackages(SamiModule module) {
        JavaClasses classes = seen(module);

        slices().matching("org.sami.(**)")
                .should()
                .beFreeOfCycles()
                .allowEmptyShould(true)
                .check(classes);
    }

    @Test
    void seesTheWholeOfSami() {
        int all = Arrays.stream(SamiModule.values())
                .mapToInt(module -> module.classes().size())
                .sum();

        assertThat(all).isGreaterThanOrEqualTo(LEAST_CLASSES_OF_ALL);
    }

    @Test
    void everyModuleWithSourcesIsOnTheMap() throws Exception {
        String settings = Files.readString(Path.of("settings.gradle"));

        long included =
                settings.lines().filter(line -> line.startsWith("include ")).count();

        // domain-config holds no code
        assertThat(included).isEqualTo(SamiModule.values().length + 1L);
        assertThat(SamiModule.Sources.below(Path.of("domain-config", "src", "main")))
                .isEmpty();
    }

    private static JavaClasses seen(SamiModule module) {
        JavaClasses classes = module.classes();
        assertThat(classes.size()).as("classes seen in %s", module).isGreaterThanOrEqualTo(module.leastClasses());
        return classes;
    }
}
