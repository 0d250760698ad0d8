package org.sami.dreamm.issues;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Rectangle;
import java.util.List;
import java.util.Optional;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.JViewport;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.dreamm.OnEventThread;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.context.LibraryProject;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.palette.Theme;
import org.sami.spn.advice.FindingAdvice;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.finding.Advice;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.ui.check.Layout;
import org.sami.ui.look.Look;

/** The panel of issues at sizes that it has in a window of 1280 by 800 pixels. */
@Isolated("the look is one for all windows of a process")
@ExtendWith(OnEventThread.class)
class IssuesPanelTest {
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private DreammContext context;
    private IssueList issues;
    private IssueCommands commands;
    private IssuesPanel panel;

    @BeforeEach
    void open() {
        context = new DreammContext(
                LIBRARY,
                new ProjectDocument(LIBRARY.vocabulary(), LibraryProject.of(LIBRARY), Optional.empty()),
                Profile.ALL);
        context.editor().open("clv-interrupts");
        DeepSearch endless = new DeepSearch(task -> {}, Runnable::run);
        LiveFindings live = new LiveFindings(context.document(), Runnable::run, Runnable::run, System::nanoTime);
        issues = new IssueList(context.document(), context.editor(), finding -> true, live, endless);
        commands = new IssueCommands(context, issues, endless, () -> List.of("a"), run -> {});
    }

    @AfterEach
    void close() {
        context.close();
        Look.apply(Theme.LIGHT, 100);
    }

    private void show(int percent, int width, int height) {
        Look.apply(Theme.LIGHT, percent);
        panel = new IssuesPanel(context, issues, commands);
        Layout.layOut(panel, width, height);
    }

    private void breakThePlan() {
        Plan plan = context.editor().plan().orElseThrow();
        plan.places()
                .forEach(place -> place.outputs()
                        .forEach(event -> event.fields()
                                .keySet()
                                .forEach(field ->
                                        context.apply(new FieldEdit.ClearField(plan.id(), event.id(), field)))));
        assertThat(issues.shown()).hasSizeGreaterThan(3);
        context.commands().get("issue-next").run();
    }

    private <C extends Component> C find(String name, Class<C> type) {
        return Layout.find(panel, name, type).orElseThrow();
    }

    @Test
    void inALowPanelWhatMendsAnIssueStandsBesideTheRows() {
        breakThePlan();
        show(150, 785, 208);

        JTable table = find("issues-table", JTable.class);
        Rectangle seen = ((JViewport) table.getParent()).getViewRect();
        assertThat(seen.contains(table.getCellRect(0, 0, true))).isTrue();
        assertThat(seen.contains(table.getCellRect(1, 0, true))).isTrue();
        assertIsSeenWhole("issue-fix-1", AbstractButton.class);

        Layout.layOut(panel, 785, 400);
        assertIsSeenWhole("issue-fix-1", AbstractButton.class);
        JComponent below = find("issue-message", JComponent.class);
        assertThat(below.isVisible()).isTrue();
        assertThat(SwingUtilities.convertPoint(below, 0, 0, panel).y)
                .isGreaterThan(SwingUtilities.convertPoint(table.getParent(), 0, 0, panel).y);
    }

    @Test
    void belowTheRowsStandsWhyAnIssueMattersAndHowItIsMended() {
        breakThePlan();
        show(100, 785, 400);
        Issue issue = issues.current().orElseThrow();
        Advice advice = FindingAdvice.of(issue.finding()).orElseThrow();

        assertThat(find("issue-message", JTextComponent.class).getText())
                .startsWith(issue.finding().message())
                .contains("Why it matters: " + advice.why())
                .contains("How to mend it: " + advice.mend());
        assertIsSeenWhole("issue-fix-1", AbstractButton.class);
    }

    @Test
    void aFilterSaysHowManyItHidesAndIsTakenAway() {
        breakThePlan();
        int all = issues.all().size();
        show(100, 785, 400);
        assertThat(find("issues-hidden", JComponent.class).getParent().isVisible())
                .isFalse();

        find("issues-filter", JTextComponent.class).setText("no issue says this");

        assertThat(issues.shown()).isEmpty();
        assertThat(find("issues-hidden", JLabel.class).getText())
                .isEqualTo("All " + all + " issues are hidden by the filter");
        assertThat(find("issues-hidden", JComponent.class).getParent().isVisible())
                .isTrue();

        find("issues-show-all", AbstractButton.class).doClick();
        assertThat(issues.shown()).hasSize(all);
        assertThat(find("issues-hidden", JComponent.class).getParent().isVisible())
                .isFalse();
    }

    @Test
    void theMarksOfAnIssueGoWithIt() {
        breakThePlan();
        assertThat(context.editor().highlight()).isNotEmpty();

        while (context.document().undoLabel().isPresent()) {
            context.undo();
        }

        assertThat(issues.current()).isEmpty();
        assertThat(context.editor().highlight()).isEmpty();
    }

    /** As in windows of 1280 by 800 and of 1280 by 1000 pixels. */
    @ParameterizedTest
    @CsvSource({"150, 785, 208", "200, 625, 545", "100, 785, 300"})
    void aSearchSaysInWholeWordsHowItIsDoing(int percent, int width, int height) {
        context.commands().get("deep-stuck-states").run();
        show(percent, width, height);

        JTextComponent status = find("deep-check-status", JTextComponent.class);
        assertThat(status.getText()).startsWith("Stuck states: ");
        assertIsSeenWhole("deep-check-status", JTextComponent.class);
        assertThat(status.getHeight()).isGreaterThanOrEqualTo(status.getPreferredSize().height);
        assertIsSeenWhole("deep-stop", AbstractButton.class);
        assertThat(find("deep-stop", AbstractButton.class).getToolTipText()).startsWith("Stop the search");
    }

    private void assertIsSeenWhole(String name, Class<? extends Component> type) {
        Component part = find(name, type);
        assertThat(part.isVisible()).as(name).isTrue();
        assertThat(part.getWidth())
                .as(name)
                .isGreaterThanOrEqualTo(
                        part instanceof JTextComponent ? part.getMinimumSize().width : part.getPreferredSize().width);
        Rectangle seen = SwingUtilities.convertRectangle(part.getParent(), part.getBounds(), panel);
        assertThat(new Rectangle(panel.getSize()).contains(seen))
                .as(name + " in " + seen)
                .isTrue();
    }
}
