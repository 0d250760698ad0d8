package org.sami.architecture;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.Architectures.layeredArchitecture;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Holds the engine to its layers: net, state, rules and codec, and on top what others may use. */
class EngineLayersTest {
    private static final String ENGINE = "org.sami.spn.engine";
    private static final String[] INNER = {
        ENGINE + ".net..", ENGINE + ".state..", ENGINE + ".rule..", ENGINE + ".codec.."
    };

    private static final Pattern INNER_IMPORT = Pattern.compile(
            "^import (?:static )?org\\.sami\\.spn\\.engine\\.(?:net|state|rule|codec)\\.", Pattern.MULTILINE);

    @ParameterizedTest
    @ValueSource(strings = {"net", "state", "rule", "codec"})
    void hasClassesInEveryLayer(String layer) {
        assertThat(SamiModule.SPN_CORE.classes().stream()
                        .filter(javaClass -> javaClass.getPackageName().equals(ENGINE + "." + layer))
                        .toList())
                .hasSizeGreaterThan(5);
    }

    @Test
    void dependsOnLowerLayersOnly() {
        layeredArchitecture()
                .consideringOnlyDependenciesInLayers()
                .layer("net")
                .definedBy(ENGINE + ".net..")
                .layer("state")
                .definedBy(ENGINE + ".state..")
                .layer("rule")
                .definedBy(ENGINE + ".rule..")
                .layer("codec")
                .definedBy(ENGINE + ".codec..")
                .layer("engine")
                .definedBy(ENGINE)
                .whereLayer("net")
                .mayNotAccessAnyLayer()
                .whereLayer("state")
                .mayOnlyAccessLayers("net")
                .whereLayer("rule")
                .mayOnlyAccessLayers("state", "net")
                .whereLayer("codec")
                .mayOnlyAccessLayers("state", "net")
                .check(SamiModule.SPN_CORE.classes());
    }

    @ParameterizedTest
    @MethodSource("org.sami.architecture.SamiModule#built")
    void keepsItsInnerPackagesToItself(SamiModule module) {
        noClasses()
                .that()
                .resideOutsideOfPackages(ENGINE + "..")
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage(INNER)
                .check(module.classes());
    }

    @ParameterizedTest
    @MethodSource("org.sami.architecture.SamiModule#built")
    void isTestedFromOutside(SamiModule module) throws IOException {
        List<Path> insiders = new ArrayList<>();
        for (Path test : module.testSources()) {
            if (INNER_IMPORT.matcher(Files.readString(test)).find()) {
                insiders.add(test);
            }
        }

        assertThat(insiders).isEmpty();
    }
}
