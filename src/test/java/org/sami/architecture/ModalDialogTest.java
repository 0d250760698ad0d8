package org.sami.architecture;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.assignableTo;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.lang.ArchRule;
import java.awt.Dialog;
import java.util.Set;
import javax.swing.JColorChooser;
import javax.swing.JFileChooser;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.architecture.sample.AsksInAnOptionPane;
import org.sami.architecture.sample.ChoosesAFileInADialog;
import org.sami.architecture.sample.OpensAModalDialog;
import org.sami.architecture.sample.ShowsAWindow;

/**
 * Nothing in the operator's window is modal: a modal dialog would take the fleet stop from the pointer (docs/windows.md). That the rules notice
 * what they forbid is tried on samples.
 */
class ModalDialogTest {
    private static final Set<String> OPENING = Set.of("showOpenDialog", "showSaveDialog", "showDialog");

    private static final DescribedPredicate<JavaAccess<?>> WAITS_IN_A_DIALOG =
            describe("wait in a dialog", ModalDialogTest::waits);

    private static final ArchRule NOTHING_IS_MODAL = noClasses()
            .should()
            .dependOnClassesThat()
            .haveNameMatching("javax\\.swing\\.(JOptionPane|ProgressMonitor.*)|java\\.awt\\.(FileDialog|PrintJob)")
            .orShould()
            .accessTargetWhere(WAITS_IN_A_DIALOG);

    private static final ArchRule NO_DIALOG = noClasses().should().dependOnClassesThat(assignableTo(Dialog.class));

    private static boolean waits(JavaAccess<?> access) {
        JavaClass owner = access.getTarget().getOwner();
        String name = access.getTarget().getName();
        if (owner.isAssignableTo(JFileChooser.class) || owner.isAssignableTo(JColorChooser.class)) {
            return OPENING.contains(name);
        }
        if (!owner.isAssignableTo(Dialog.class)) {
            return false;
        }
        boolean modalByConstruction =
                name.equals("<init>") && access.getTarget().getFullName().matches(".*\\(.*(boolean|ModalityType).*\\)");
        return modalByConstruction || name.equals("setModal") || name.equals("setModalityType");
    }

    @ParameterizedTest
    @EnumSource(
            value = SamiModule.class,
            names = {"UI_KIT", "OPERATOR_WINDOW"})
    void nothingInTheOperatorsWindowWaitsInAModalDialog(SamiModule module) {
        NOTHING_IS_MODAL.check(module.classes());
    }

    @Test
    void theOperatorsWindowAsksInSheetsAndNotInDialogs() {
        NO_DIALOG.check(SamiModule.OPERATOR_WINDOW.classes());
    }

    @ParameterizedTest
    @ValueSource(classes = {OpensAModalDialog.class, AsksInAnOptionPane.class, ChoosesAFileInADialog.class})
    void noticesWhatWaitsInADialog(Class<?> sample) {
        assertThatThrownBy(() -> NOTHING_IS_MODAL.check(sample(sample))).isInstanceOf(AssertionError.class);
    }

    @Test
    void allowsAWindowWithoutDialogs() {
        NOTHING_IS_MODAL.check(sample(ShowsAWindow.class));
        NO_DIALOG.check(sample(ShowsAWindow.class));
    }

    private static JavaClasses sample(Class<?> sample) {
        return new ClassFileImporter().importClasses(sample);
    }
}
