package org.sami.dreamm.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JViewport;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.dreamm.canvas.ModelView;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.dreamm.replay.RecordedSession;
import org.sami.dreamm.replay.ReplayPanel;
import org.sami.palette.Theme;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.ui.check.Layout;
import org.sami.ui.check.TextFit;
import org.sami.ui.dock.PanelSizes;
import org.sami.ui.look.Look;

/** The panels that check and run a plan, without a window: they are laid out, painted and used by their names. */
@Isolated("the look is one for all windows of a process")
class RunPanelsTest {
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final Dimension SIZE = new Dimension(1000, 320);

    private DreammContext context;
    private RunParts parts;

    private void onEventThread(Runnable work) throws Exception {
        SwingUtilities.invokeAndWait(work);
    }

    private void open() {
        context = new DreammContext(
                LIBRARY,
                new ProjectDocument(
                        LIBRARY.vocabulary(), LIBRARY.projectOf("clv").orElseThrow(), Optional.empty()),
                Profile.ALL);
        parts = new RunParts(context);
    }

    @AfterEach
    void close() throws Exception {
        onEventThread(() -> {
            if (parts != null) {
                parts.close();
                context.close();
            }
        });
    }

    private static void layOut(JComponent panel) {
        Layout.layOut(panel, SIZE.width, SIZE.height);
    }

    /** Rows of tables end with an ellipsis and say all in their tooltips. */
    private static List<String> faults(JComponent panel) {
        return TextFit.faults(panel).stream()
                .filter(fault -> !fault.contains(" cuts row "))
                .toList();
    }

    private static JTable table(JComponent panel, String name) {
        return Layout.find(panel, name, JTable.class).orElseThrow();
    }

    @ParameterizedTest
    @EnumSource(Theme.class)
    void noTextIsCutWhileAPlanIsTried(Theme theme) throws Exception {
        onEventThread(() -> {
            Look.apply(theme, 100);
            open();
            JComponent panel = parts.tryOut();
            context.commands().get("try-start").run();
            context.commands().get("try-step").run();
            layOut(panel);

            assertThat(faults(panel)).isEmpty();
            assertThat(Layout.paint(panel)).isNotNull();
            assertThat(table(panel, "try-possible-steps").getRowCount()).isPositive();
            assertThat(table(panel, "try-steps").getRowCount()).isEqualTo(1);
        });
    }

    /** Opens the plan; the panel is as in a window of 1280 by 800 pixels with letters of 150 %. */
    private JComponent openInASmallWindow() {
        Look.apply(Theme.LIGHT, 150);
        open();
        JComponent panel = parts.tryOut();
        Layout.layOut(panel, 786, 197);
        return panel;
    }

    @Test
    void inASmallPanelWhatCanHappenHasItsRoomAndNoButtonIsCut() throws Exception {
        onEventThread(() -> {
            JComponent panel = openInASmallWindow();
            context.commands().get("try-start").run();
            Layout.layOut(panel, 786, 197);

            assertThat(faults(panel)).isEmpty();
            assertThat(table(panel, "try-possible-steps").getWidth()).isGreaterThan(240);

            Layout.layOut(panel, 1400, 480);
            assertThat(faults(panel)).isEmpty();
            Look.apply(Theme.LIGHT, 100);
        });
    }

    @Test
    void inASmallWindowWhatCanHappenIsSeenAndTheNumbersHaveTheirNames() throws Exception {
        onEventThread(() -> {
            JComponent panel = openInASmallWindow();
            context.commands().get("try-start").run();
            Dimension area = new Dimension(1280, 800 - Look.px(90));
            Dimension room =
                    PanelSizes.of(DreammPanels.FIRST.fitting(area), area).get("try-out");
            for (Dimension size : List.of(room, new Dimension(786, 197))) {
                Layout.layOut(panel, size.width, size.height);
                Layout.layOut(panel, size.width, size.height);

                assertThat(faults(panel)).as("%s", size).isEmpty();
                JTable steps = table(panel, "try-possible-steps");
                assertThat(steps.getVisibleRect().height).as("%s", size).isGreaterThanOrEqualTo(steps.getRowHeight());
                JTabbedPane tabs =
                        Layout.find(panel, "try-tabs", JTabbedPane.class).orElseThrow();
                tabs.setSelectedIndex(tabs.indexOfTab("Settings"));
                Layout.layOut(panel, size.width, size.height);
                assertThat(faults(panel)).as("%s", size).isEmpty();
                for (String number : List.of("try-robots", "try-locations")) {
                    assertThat(labelOf(panel, number).isVisible()
                                    && labelOf(panel, number).getWidth() > 0)
                            .isTrue();
                    assertThat(isShown(panel, number)).isTrue();
                }
                tabs.setSelectedIndex(0);
            }
            Look.apply(Theme.LIGHT, 100);
        });
    }

    @ParameterizedTest
    @ValueSource(ints = {100, 150, 200})
    void noButtonIsCutInAnyWidth(int percent) throws Exception {
        onEventThread(() -> {
            Look.apply(Theme.LIGHT, percent);
            open();
            JComponent panel = parts.tryOut();
            context.commands().get("try-start").run();
            List<String> cut = new ArrayList<>();
            for (int width = 530; width <= 1300; width += 10) {
                Layout.layOut(panel, Look.px(width), Look.px(300));
                for (String fault : faults(panel)) {
                    cut.add("at " + width + ": " + fault);
                }
            }
            assertThat(cut).isEmpty();
            Look.apply(Theme.LIGHT, 100);
        });
    }

    private static JLabel labelOf(JComponent panel, String field) {
        JComponent of = Layout.find(panel, field, JComponent.class).orElseThrow();
        return (JLabel) of.getClientProperty("labeledBy");
    }

    @Test
    void inASmallPanelALongMessageLeavesTheTabsTheirRoom() throws Exception {
        JComponent[] opened = new JComponent[1];
        CountDownLatch told = new CountDownLatch(1);
        onEventThread(() -> {
            JComponent panel = openInASmallWindow();
            opened[0] = panel;
            Layout.find(panel, "try-message", JLabel.class).orElseThrow().addPropertyChangeListener("text", change -> {
                if (String.valueOf(change.getNewValue()).startsWith("Nothing goes on by itself")) {
                    told.countDown();
                }
            });
            context.commands().get("try-start").run();
            Layout.find(panel, "try-operator-answers", AbstractButton.class)
                    .orElseThrow()
                    .doClick();
            context.commands().get("try-step").run();
        });
        assertThat(told.await(60, TimeUnit.SECONDS)).isTrue();
        onEventThread(() -> {
            JComponent panel = opened[0];
            Layout.layOut(panel, 786, 197);
            JTabbedPane tabs = Layout.find(panel, "try-tabs", JTabbedPane.class).orElseThrow();
            JComponent happen =
                    Layout.find(panel, "try-happen", JComponent.class).orElseThrow();
            Rectangle last = tabs.getBoundsAt(tabs.getTabCount() - 1);
            JComponent viewport = (JComponent) Arrays.stream(tabs.getComponents())
                    .filter(JViewport.class::isInstance)
                    .findFirst()
                    .orElseThrow();
            assertThat(viewport.getWidth()).isGreaterThanOrEqualTo(last.x + last.width);
            assertThat(happen.getWidth()).isGreaterThanOrEqualTo(happen.getPreferredSize().width);
            Look.apply(Theme.LIGHT, 100);
        });
    }

    @Test
    void inASmallPanelTheListHasAllTheRoomUntilSomethingCanHappen() throws Exception {
        onEventThread(() -> {
            JComponent panel = openInASmallWindow();
            assertThat(faults(panel)).isEmpty();
            assertThat(table(panel, "try-possible-steps").getWidth()).isGreaterThan(740);

            context.commands().get("try-start").run();
            Layout.layOut(panel, 786, 197);
            assertThat(table(panel, "try-possible-steps").getWidth()).isLessThan(400);

            context.commands().get("try-stop").run();
            Layout.layOut(panel, 786, 197);
            assertThat(table(panel, "try-possible-steps").getWidth()).isGreaterThan(740);
            Look.apply(Theme.LIGHT, 100);
        });
    }

    /** As it is in a window of 1280 by 800 pixels with letters of 150 %. */
    @Test
    void inALowPanelTheMissionsOfAJournalHaveRoomBesideItsTimeLine(@TempDir Path folder) throws Exception {
        Path journal = RecordedSession.write(folder.resolve("session.journal"));
        ReplayPanel[] panel = new ReplayPanel[1];
        CountDownLatch opened = new CountDownLatch(1);
        CountDownLatch shown = new CountDownLatch(1);
        onEventThread(() -> {
            Look.apply(Theme.LIGHT, 150);
            open();
            panel[0] = parts.replay();
            Layout.layOut(panel[0], 786, 197);
            assertThat(isShown(panel[0], "time-line-panel")).isFalse();
            JTable missions = table(panel[0], "replay-missions");
            missions.getModel().addTableModelListener(e -> {
                if (missions.getRowCount() > 0) {
                    shown.countDown();
                }
            });
            Layout.find(panel[0], "time-line-panel", JComponent.class)
                    .orElseThrow()
                    .addComponentListener(new ComponentAdapter() {
                        @Override
                        public void componentShown(ComponentEvent e) {
                            opened.countDown();
                        }
                    });
            panel[0].open(journal);
        });
        assertThat(opened.await(60, TimeUnit.SECONDS)).isTrue();
        onEventThread(() -> context.commands().get("replay-end").run());
        assertThat(shown.await(60, TimeUnit.SECONDS)).isTrue();
        onEventThread(() -> {
            Layout.layOut(panel[0], 786, 197);
            assertThat(isShown(panel[0], "time-line-panel")).isTrue();
            JTable missions = table(panel[0], "replay-missions");
            assertThat(missions.getVisibleRect().height).isGreaterThanOrEqualTo(missions.getRowHeight());
            assertThat(faults(panel[0])).isEmpty();

            Layout.layOut(panel[0], 786, 400);
            assertThat(isShown(panel[0], "replay-file")).isTrue();
            Look.apply(Theme.LIGHT, 100);
        });
    }

    private static boolean isShown(JComponent panel, String name) {
        for (Component each = Layout.find(panel, name, JComponent.class).orElseThrow();
                each != panel;
                each = each.getParent()) {
            if (!each.isVisible()) {
                return false;
            }
        }
        return true;
    }

    @Test
    void whatCanHappenIsLetHappenByItsButton() throws Exception {
        onEventThread(() -> {
            Look.apply(Theme.LIGHT, 100);
            open();
            JComponent panel = parts.tryOut();
            context.commands().get("try-start").run();
            layOut(panel);

            Layout.find(panel, "try-happen", AbstractButton.class).orElseThrow().doClick();

            assertThat(table(panel, "try-steps").getRowCount()).isEqualTo(1);
            assertThat(table(panel, "try-steps").getValueAt(0, 1).toString()).startsWith("operator: ");
            assertThat(context.overlay().shown().marking().tokens()).isNotEmpty();
            context.commands().get("try-back").run();
            assertThat(table(panel, "try-steps").getRowCount()).isZero();
        });
    }

    @Test
    void tokensAndBreakpointsOfWhatIsTriedLieOverTheNet() throws Exception {
        onEventThread(() -> {
            Look.apply(Theme.LIGHT, 100);
            open();
            JPanel net = new ModelView(context);
            layOut(net);
            BufferedImage before = Layout.paint(net);
            Plan plan = context.editor().plan().orElseThrow();
            context.editor().select(Set.of(plan.places().get(0).id()));
            context.editor().select(Set.of());
            parts.tryOut();

            context.commands().get("try-start").run();

            assertThat(context.overlay().shown().marking().tokens())
                    .containsKey(plan.places().get(0).id());
            BufferedImage after = Layout.paint(net);
            assertThat(equal(before, after)).as("the net looks as before").isFalse();
        });
    }

    private static boolean equal(BufferedImage a, BufferedImage b) {
        for (int y = 0; y < a.getHeight(); y++) {
            for (int x = 0; x < a.getWidth(); x++) {
                if (a.getRGB(x, y) != b.getRGB(x, y)) {
                    return false;
                }
            }
        }
        return true;
    }

    @Test
    void issueIsFoundShownAndMendedByKeys() throws Exception {
        CountDownLatch checked = new CountDownLatch(1);
        JComponent[] panel = new JComponent[1];
        onEventThread(() -> {
            Look.apply(Theme.LIGHT, 100);
            open();
            panel[0] = parts.issues();
            Plan plan = context.editor().plan().orElseThrow();
            context.apply(new RemoveElements(
                    plan.id(), Set.of(plan.startPlace().orElseThrow().id())));
            parts.issueList().addListener(() -> {
                if (parts.issueList().counts().errors() > 0) {
                    checked.countDown();
                }
            });
        });
        assertThat(checked.await(60, TimeUnit.SECONDS)).isTrue();
        onEventThread(() -> {
            layOut(panel[0]);
            JTable table = table(panel[0], "issues-table");
            assertThat(table.getRowCount()).isPositive();
            context.commands().get("issue-next").run();
            layOut(panel[0]);
            assertThat(table.getSelectedRow()).isZero();
            assertThat(Layout.find(panel[0], "issue-message", JComponent.class)
                            .orElseThrow()
                            .isVisible())
                    .isTrue();
            assertThat(faults(panel[0])).isEmpty();
        });
    }
}
