package org.sami.architecture;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaCall.Predicates.target;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.assignableTo;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.nameMatching;
import static com.tngtech.archunit.core.domain.properties.HasOwner.Predicates.With.owner;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noMethods;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaModifier;
import java.io.DataInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.sami.spn.host.EngineHost;

/** What a module may not touch outside SAMI, and which words are not its own. */
class BorderTest {
    private static final int JAVA_8_CLASS_FILE = 52;

    @ParameterizedTest
    @EnumSource(
            value = SamiModule.class,
            names = {
                "SPN_LANGUAGE",
                "SPN_CORE",
                "SPN_AUTHORING",
                "PETRI",
                "BOAT_LINK",
                "BOAT_SERVER",
                "CRW_SERVICES",
                "CRW_DOMAIN",
                "SESSION_API",
                "CRW_SESSION"
            })
    void hasNoWindows(SamiModule module) {
        noClasses()
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage("java.awt..", "javax.swing..", "javax.imageio..")
                .check(module.classes());
    }

    /** The lock rule (docs/threads.md): a window may call every public method of a model on its event thread. */
    @Test
    void modelsCallNothingThatWaits() {
        JavaClasses classes = SamiModule.SESSION_API.classes();
        assertThat(classes.that(resideInAPackage("org.sami.crw.operator..")).size())
                .as("classes seen among the models")
                .isGreaterThan(20);

        noClasses()
                .that()
                .resideInAPackage("org.sami.crw.operator..")
                .should()
                .callMethodWhere(target(
                                nameMatching("join|get|getNow|await.*|acquire.*|take|put|lock.*|invokeAll|invokeAny"))
                        .and(target(owner(resideInAnyPackage("java.util.concurrent", "java.util.concurrent.locks"))))
                        .and(not(target(owner(assignableTo(AtomicLong.class)))))
                        .and(not(target(owner(assignableTo(Map.class)))))
                        .as("a call of java.util.concurrent that waits"))
                .orShould()
                .callMethod(Thread.class, "sleep", long.class)
                .orShould()
                .callMethod(Object.class, "wait")
                .orShould()
                .callMethod(EngineHost.class, "ask", Function.class)
                .check(classes);
        noMethods()
                .that()
                .areDeclaredInClassesThat()
                .resideInAPackage("org.sami.crw.operator..")
                .should()
                .haveModifier(JavaModifier.SYNCHRONIZED)
                .check(classes);
    }

    /** Who reaches a session, and how, is its implementation's: programs use the module with a transport of their own. */
    @Test
    void whatFrontsAskAndSeeHasNoTransport() {
        noClasses()
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage("java.net..", "javax.net..", "java.nio.channels..", "org.eclipse.jetty..")
                .check(SamiModule.SESSION_API.classes());
    }

    @ParameterizedTest
    @EnumSource(
            value = SamiModule.class,
            names = {"NET_PICTURE", "CRW_REPORT", "CRW_SIM", "CRW_CLI"})
    void simulatorAndCommandDrawPicturesButOpenNoWindow(SamiModule module) {
        noClasses()
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage("javax.swing..", "java.awt.event..")
                .check(module.classes());
    }

    @ParameterizedTest
    @EnumSource(
            value = SamiModule.class,
            names = {"SPN_LANGUAGE", "SPN_CORE", "SPN_AUTHORING"})
    void languageHasNoBoatInItsNames(SamiModule module) {
        JavaClasses classes = module.classes();

        List<String> boatish = classes.stream()
                .map(javaClass -> javaClass.getName())
                .filter(name -> name.contains("Boat") || name.contains("Crw"))
                .toList();

        assertThat(boatish).isEmpty();
    }

    @Test
    void linkKnowsStreamsAndNoSockets() {
        noClasses()
                .that()
                .resideOutsideOfPackage("org.sami.boat.link.security..") // which puts TLS around a socket of its caller
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage("java.net..", "javax.net..", "java.nio.channels..")
                .check(SamiModule.BOAT_LINK.classes());
    }

    @Test
    void engineIsAFunctionWithoutThreadsClocksChanceOrFiles() {
        JavaClasses classes = SamiModule.SPN_CORE.classes();
        assertThat(classes.that(resideInAPackage("org.sami.spn.engine..")).size())
                .as("classes seen in the engine")
                .isGreaterThan(50);

        noClasses()
                .that()
                .resideInAPackage("org.sami.spn.engine..")
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage(
                        "java.nio.file..", "java.nio.channels..", "java.net..", "java.sql..", "java.util.concurrent..")
                .orShould()
                .dependOnClassesThat()
                .haveNameMatching("java\\.io\\.(File|RandomAccess).*")
                .orShould()
                .dependOnClassesThat()
                .haveFullyQualifiedName("java.util.Random")
                .orShould()
                .dependOnClassesThat()
                .haveFullyQualifiedName("java.lang.Thread")
                .orShould()
                .dependOnClassesThat()
                .haveFullyQualifiedName("java.time.Clock")
                .orShould()
                .callMethod(System.class, "currentTimeMillis")
                .orShould()
                .callMethod(System.class, "nanoTime")
                .orShould()
                .callMethod(System.class, "identityHashCode", Object.class)
                .orShould()
                .callMethod(Math.class, "random")
                .orShould()
                .callMethod(java.time.Instant.class, "now")
                .check(classes);
    }

    @ParameterizedTest
    @EnumSource(
            value = SamiModule.class,
            names = {"BOAT_LINK", "BOAT_SERVER"})
    void runsOnTheJavaOfThePhone(SamiModule module) throws IOException {
        try (Stream<Path> all = Files.walk(module.classesFolder())) {
            List<Path> files = all.filter(path -> path.toString().endsWith(".class"))
                    .sorted()
                    .toList();

            assertThat(files)
                    .isNotEmpty()
                    .allSatisfy(file -> assertThat(majorVersion(file)).isLessThanOrEqualTo(JAVA_8_CLASS_FILE));
        }
    }

    private static int majorVersion(Path classFile) throws IOException {
        try (DataInputStream in = new DataInputStream(Files.newInputStream(classFile))) {
            in.readInt();
            in.readUnsignedShort();
            return in.readUnsignedShort();
        }
    }
}
