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
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Holds the modules to the map. Every rule first makes sure that it saw the classes it speaks of. */
class ModuleMapTest {
    /** The part of a module's classes that its least number is to be of, so that a half-empty import is noticed. */
    private static final double PART = 0.75;

    private static final Pattern ARROW = Pattern.compile("(?m)^ +([\\w-]+) --> ([\\w-]+)$");

    @ParameterizedTest
    @MethodSource("org.sami.architecture.SamiModule#built")
    void keepsToItsOwnPackages(SamiModule module) {
        JavaClasses classes = module.classes();

        classes().should().resideInAnyPackage(module.packages()).check(classes);
    }

    @ParameterizedTest
    @MethodSource("org.sami.architecture.SamiModule#built")
    void knowsOnlyTheModulesOfTheMap(SamiModule module) {
        JavaClasses classes = module.classes();

        noClasses()
                .should()
                .dependOnClassesThat(
                        resideInAPackage("org.sami..").and(not(resideInAnyPackage(module.knownPackages()))))
                .check(classes);
    }

    @ParameterizedTest
    @MethodSource("org.sami.architecture.SamiModule#built")
    void hasNoCyclesOfPackages(SamiModule module) {
        JavaClasses classes = module.classes();

        slices().matching("org.sami.(**)")
                .should()
                .beFreeOfCycles()
                .allowEmptyShould(true)
                .check(classes);
    }

    @ParameterizedTest
    @MethodSource("org.sami.architecture.SamiModule#built")
    void leastNumberOfClassesIsNearTheRealOne(SamiModule module) {
        assertThat(module.leastClasses()).isGreaterThan((int) (module.classes().size() * PART));
    }

    /** An arrow to a module that is reached through another one is left out, so that the diagram can be read. */
    @Test
    void diagramOfTheArchitecturePageShowsTheMap() throws Exception {
        String page = Files.readString(Path.of("ARCHITECTURE.md"));

        List<String> drawn = ARROW.matcher(page)
                .results()
                .map(arrow -> arrow.group(1) + " --> " + arrow.group(2))
                .toList();

        assertThat(drawn)
                .containsExactlyInAnyOrderElementsOf(SamiModule.built()
                        .flatMap(module ->
                                module.neighbours().map(known -> module.diagramName() + " --> " + known.diagramName()))
                        .toList());
    }

    @Test
    void everyModuleWithSourcesIsOnTheMap() throws Exception {
        String settings = Files.readString(Path.of("settings.gradle"));

        long included =
                settings.lines().filter(line -> line.startsWith("include ")).count();

        // domain-config holds no code
        assertThat(included).isEqualTo(SamiModule.built().count() + 1);
        assertThat(SamiModule.Sources.below(Path.of("domain-config", "src", "main")))
                .isEmpty();
    }
}
