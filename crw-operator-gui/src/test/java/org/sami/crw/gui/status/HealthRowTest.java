package org.sami.crw.gui.status;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.SessionWorld.until;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.operator.HealthModel;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.spn.protocol.Priority;
import org.sami.ui.check.Layout;
import org.sami.ui.check.TextFit;
import org.sami.ui.command.Command;
import org.sami.ui.look.Look;
import org.sami.ui.look.Theme;

@Isolated("the look is one for all windows of a process")
class HealthRowTest {
    private static final HealthFault FULL = HealthFault.ofSession(
            HealthKind.JOURNAL,
            Priority.CRITICAL,
            "The journal cannot be written: the disk is full",
            "Make room on the disk");
    private static final HealthFault DRIFT = HealthFault.ofBoat(
            HealthKind.DRIFT, "anna", Priority.HIGH, "anna drifts 0.3 m/s", "Have it hold its place");

    private final List<String> shown = new ArrayList<>();
    private SessionWorld world;
    private HealthModel health;

    @BeforeEach
    void open() throws Exception {
        world = new SessionWorld(SessionWorld.library("clv"), "anna");
        health = world.context.models().health();
    }

    @AfterEach
    void close() throws Exception {
        Look.apply(Theme.LIGHT, 100);
        world.close();
    }

    private HealthRow row() throws Exception {
        HealthRow[] made = new HealthRow[1];
        SwingUtilities.invokeAndWait(() ->
                made[0] = new HealthRow(world.context, new Command("panel-health", "Health", () -> shown.add("all"))));
        return made[0];
    }

    private static String text(HealthRow row, String name) {
        return Layout.find(row, name, JLabel.class).orElseThrow().getText();
    }

    @Test
    void theWorstFaultStandsThereUntilItIsOver() throws Exception {
        HealthRow row = row();
        assertThat(text(row, "health-worst")).isEqualTo("● No fault");

        health.report(DRIFT);
        health.report(FULL);
        until("the worst is shown", () -> text(row, "health-worst").startsWith("▲ The journal cannot be written"));
        assertThat(text(row, "health-advice")).isEqualTo("Make room on the disk");
        assertThat(text(row, "health-others")).isEqualTo("1 more");
        assertThat(row.getAccessibleContext().getAccessibleName())
                .contains("disk is full")
                .contains("1 more");

        health.over(HealthKind.JOURNAL, "");
        until("what is left is shown", () -> text(row, "health-worst").startsWith("△ anna drifts 0.3 m/s, since"));
        health.over(HealthKind.DRIFT, "anna");
        until("nothing is wrong", () -> text(row, "health-worst").equals("● No fault"));
    }

    @Test
    void nothingMovesWhenAFaultComes() throws Exception {
        HealthRow row = row();
        int before = row.getPreferredSize().height;

        health.report(FULL);
        until("it is shown", () -> text(row, "health-worst").contains("disk"));

        assertThat(row.getPreferredSize().height).isEqualTo(before).isGreaterThanOrEqualTo(40);
    }

    @Test
    void pressingItShowsAllFaults() throws Exception {
        HealthRow row = row();

        SwingUtilities.invokeAndWait(row::doClick);

        assertThat(shown).containsExactly("all");
    }

    @Test
    void onANarrowWindowWhatIsWrongIsReadAndTheAdviceGivesWay() throws Exception {
        HealthRow row = row();
        health.report(FULL);
        until("it is shown", () -> text(row, "health-worst").contains("disk"));

        SwingUtilities.invokeAndWait(() -> {
            Layout.layOut(row, 620, row.getPreferredSize().height);
            JLabel what = Layout.find(row, "health-worst", JLabel.class).orElseThrow();
            assertThat(what.getWidth()).isGreaterThanOrEqualTo(what.getPreferredSize().width);
            assertThat(TextFit.faults(what)).isEmpty();
        });
    }
}
