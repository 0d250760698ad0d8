package org.sami.architecture;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.lang.ArchRule;
import java.util.Arrays;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.architecture.sample.AsksTheEventThread;
import org.sami.architecture.sample.HopsToTheEventThread;
import org.sami.architecture.sample.KnowsABoat;
import org.sami.architecture.sample.QueuesAnEvent;
import org.sami.architecture.sample.ShowsAWindow;

/**
 * What windows may know, and what may know windows. The rules hold for the modules of windows from their first class on; that they
 * notice what they forbid is tried on samples.
 */
class WindowTest {
    /** The one class that hands work to the event thread, and asks whether this is it. */
    private static final String BORDER = "org.sami.ui.EventThread";

    private static final String[] BOATS = {"org.sami.boat..", "org.sami.crw.."};
    private static final String[] WINDOWS = {"java.awt..", "javax.swing.."};

    private static final ArchRule KNOW_NO_BOAT =
            noClasses().should().dependOnClassesThat().resideInAnyPackage(BOATS);

    private static final ArchRule KNOW_NO_WINDOW =
            noClasses().should().dependOnClassesThat().resideInAnyPackage(WINDOWS);

    private static final ArchRule LEAVE_THE_EVENT_THREAD_TO_ITS_BORDER = noClasses()
            .that()
            .doNotHaveFullyQualifiedName(BORDER)
            .should()
            .dependOnClassesThat()
            .haveFullyQualifiedName("java.awt.EventQueue")
            .orShould()
            .dependOnClassesThat()
            .haveFullyQualifiedName("javax.swing.SwingWorker")
            .orShould()
            .callMethod(javax.swing.SwingUtilities.class, "invokeLater", Runnable.class)
            .orShould()
            .callMethod(javax.swing.SwingUtilities.class, "invokeAndWait", Runnable.class)
            .orShould()
            .callMethod(javax.swing.SwingUtilities.class, "isEventDispatchThread");

    @ParameterizedTest
    @EnumSource(
            value = SamiModule.class,
            names = {"UI_KIT", "DREAMM_IDE"})
    void editorAndWhatWindowsShareMayKnowNoBoat(SamiModule module) {
        assertThat(module.knownPackages()).contains("org.sami.spn.model..").noneMatch(WindowTest::isOfBoats);
        if (SamiModule.built().anyMatch(module::equals)) {
            KNOW_NO_BOAT.check(module.classes());
        }
    }

    private static boolean isOfBoats(String known) {
        return Stream.of(BOATS).map(each -> each.replace("..", "")).anyMatch(known::startsWith);
    }

    @ParameterizedTest
    @CsvSource({"SESSION_API, org.sami.crw.operator..", "CRW_DOMAIN, org.sami.crw.decision.."})
    void modelsThatWindowsShowKnowNoWindow(SamiModule module, String models) {
        JavaClasses classes = module.classes().that(resideInAnyPackage(models));

        KNOW_NO_WINDOW.allowEmptyShould(true).check(classes);
        assertThat(module.packages()).contains(models);
    }

    @ParameterizedTest
    @MethodSource("org.sami.architecture.SamiModule#built")
    void oneClassIsTheBorderToTheEventThread(SamiModule module) {
        LEAVE_THE_EVENT_THREAD_TO_ITS_BORDER.allowEmptyShould(true).check(module.classes());
    }

    @Test
    void noticesABoat() {
        assertThatThrownBy(() -> KNOW_NO_BOAT.check(sample(KnowsABoat.class))).isInstanceOf(AssertionError.class);
    }

    @Test
    void noticesAWindow() {
        assertThatThrownBy(() -> KNOW_NO_WINDOW.check(sample(ShowsAWindow.class)))
                .isInstanceOf(AssertionError.class);
    }

    @ParameterizedTest
    @ValueSource(classes = {HopsToTheEventThread.class, AsksTheEventThread.class, QueuesAnEvent.class})
    void noticesASecondBorderToTheEventThread(Class<?> second) {
        assertThatThrownBy(() -> LEAVE_THE_EVENT_THREAD_TO_ITS_BORDER.check(sample(second)))
                .isInstanceOf(AssertionError.class);
    }

    @Test
    void allowsAWindowThatLeavesThreadsAlone() {
        LEAVE_THE_EVENT_THREAD_TO_ITS_BORDER.check(sample(ShowsAWindow.class));
        KNOW_NO_BOAT.check(sample(ShowsAWindow.class));
    }

    private static JavaClasses sample(Class<?>... samples) {
        JavaClasses classes = new ClassFileImporter().importClasses(samples);
        assertThat(classes.size()).isEqualTo(Arrays.asList(samples).size());
        return classes;
    }
}
