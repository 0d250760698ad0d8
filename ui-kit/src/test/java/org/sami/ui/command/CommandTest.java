package org.sami.ui.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.Action;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.sami.ui.check.Layout;
import org.sami.ui.check.TextFit;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;

class CommandTest {
    private final List<String> ran = new ArrayList<>();
    private final CommandRegistry commands = new CommandRegistry();
    private Optional<String> reason = Optional.of("no mission runs");

    private Command abort() {
        return new Command("mission-abort", "Abort mission", () -> ran.add("abort"))
                .withKey("ctrl shift X")
                .unless(() -> reason);
    }

    @Test
    void lockIsThatOfThePolicyWhenItWasAskedLast() {
        CommandRegistry locked = new CommandRegistry(new CommandPolicy() {
            @Override
            public Optional<String> whyLocked(String id) {
                return reason;
            }
        });
        Command fit = locked.add(new Command("map-fit", "Fit", () -> ran.add("fit")));
        assertThat(fit.whyNot()).contains("no mission runs");

        reason = Optional.empty();
        fit.run();
        assertThat(ran).isEmpty();
        locked.askPolicy();
        fit.run();
        assertThat(ran).containsExactly("fit");

        reason = Optional.of("the role is another");
        locked.askPolicy();
        assertThat(fit.isEnabled()).isFalse();
        assertThat(fit.whyNot()).contains("the role is another");
    }

    @Test
    void saysWhyItCannotBeRunAndDoesNotRun() {
        JButton button = new CommandButton(abort());

        button.doClick();

        assertThat(button.isEnabled()).isFalse();
        assertThat(button.getName()).isEqualTo("mission-abort");
        assertThat(button.getToolTipText()).isEqualTo("Abort mission (Ctrl+Shift+X): no mission runs");
        assertThat(ran).isEmpty();
    }

    @Test
    void buttonsFollowWhenItCanBeRun() {
        Command abort = commands.add(abort());
        JButton button = new CommandButton(abort);

        reason = Optional.empty();
        commands.refresh();
        button.doClick();

        assertThat(ran).containsExactly("abort");
        assertThat(button.getToolTipText()).isEqualTo("Abort mission (Ctrl+Shift+X)");
    }

    @Test
    void aKeyOfWhatHasTheFocusBelongsToItAlone() {
        JButton map = new JButton();
        JButton net = new JButton();
        Command here = commands.add(new Command("map-zoom-in", "Map: zoom in", () -> ran.add("map"))
                .withFocusKeys(List.of(KeyStroke.getKeyStroke("PLUS"))));
        Command there = commands.add(new Command("net-zoom-in", "Net: zoom in", () -> ran.add("net"))
                .withFocusKeys(List.of(KeyStroke.getKeyStroke("PLUS")))
                .unless(() -> reason));
        here.bindTo(map);
        there.bindTo(net);

        assertThat(commands.ofKey(KeyStroke.getKeyStroke("PLUS"))).isEmpty();
        assertThat(here.getValue(Action.SHORT_DESCRIPTION)).isEqualTo("Map: zoom in (Plus)");
        Object name = net.getInputMap().get(KeyStroke.getKeyStroke("PLUS"));
        assertThat(net.getActionMap().get(name).isEnabled()).isFalse(); // and somebody else may have the key
        reason = Optional.empty();
        net.getActionMap().get(name).actionPerformed(null);
        assertThat(ran).containsExactly("net");
    }

    @Test
    void isNotRunOnceTheReasonIsThereThoughNobodyRefreshed() {
        reason = Optional.empty();
        Command abort = abort();
        reason = Optional.of("it has ended");

        abort.run();

        assertThat(ran).isEmpty();
        assertThat(abort.getValue(Action.SHORT_DESCRIPTION).toString()).endsWith("it has ended");
    }

    @Test
    void refusesASecondCommandOfAnIdOrKey() {
        commands.add(abort());

        assertThatIllegalArgumentException()
                .isThrownBy(() -> commands.add(new Command("mission-abort", "Abort", () -> {})))
                .withMessageContaining("mission-abort");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> commands.add(new Command("other", "Other", () -> {}).withKey("ctrl shift X")))
                .withMessageContaining("Ctrl+Shift+X");
        assertThat(commands.all()).hasSize(1);
    }

    @Test
    void typingFindsTheNearestCommandFirst() {
        Command start = commands.add(new Command("mission-start", "Start mission", () -> ran.add("start")));
        Command abort = commands.add(abort());
        Command theme = commands.add(new Command("theme-sun", "Theme: Sun", () -> {}));

        assertThat(CommandMatches.of("", commands.all())).containsExactly(start, abort, theme);
        assertThat(CommandMatches.of("miss", commands.all())).containsExactly(start, abort);
        assertThat(CommandMatches.of("s", commands.all())).startsWith(start);
        assertThat(CommandMatches.of("thsu", commands.all())).containsExactly(theme);
        assertThat(CommandMatches.of("qqq", commands.all())).isEmpty();
    }

    @Test
    void searchRunsTheChosenCommandAfterItHasLeft() {
        commands.add(abort());
        commands.add(new Command("mission-start", "Start mission", () -> ran.add("start")));
        CommandSearch search = new CommandSearch(commands, () -> ran.add("left"));

        search.type("start");
        assertThat(search.chosen()).map(Command::id).contains("mission-start");
        press(search, "ENTER");
        search.type("abort");
        press(search, "ENTER");

        assertThat(ran).containsExactly("left", "start");
    }

    @Test
    void helpListsEveryCommandWithItsKey() {
        commands.add(new Command("mission-start", "Start mission", () -> {}));
        commands.add(abort());

        CommandKeysPanel panel = new CommandKeysPanel(commands, () -> {});
        JTable table = (JTable)
                ((javax.swing.JScrollPane) panel.getComponent(0)).getViewport().getView();

        assertThat(table.getValueAt(0, 0)).isEqualTo("Abort mission");
        assertThat(table.getValueAt(0, 1)).isEqualTo("Ctrl+Shift+X");
        assertThat(table.getRowCount()).isEqualTo(2);
    }

    @Test
    void everyKeyOfTheListIsReadWhole() {
        CommandRegistry many = new CommandRegistry();
        many.add(new Command("go-on", "Release: boats go on", () -> {}).withKey("ctrl shift ENTER"));
        CommandKeysPanel panel = new CommandKeysPanel(many, () -> {});
        JTable table = Layout.find(panel, "command-keys-table", JTable.class).orElseThrow();

        table.setSize(120, 100);
        table.doLayout();

        int needed = table.prepareRenderer(table.getCellRenderer(0, 1), 0, 1).getPreferredSize().width;
        assertThat(table.getCellRect(0, 1, false).width).isGreaterThanOrEqualTo(needed);
    }

    @Test
    void escapeLeavesTheListOfKeysAlsoFromItsTable() {
        boolean[] left = {false};
        CommandKeysPanel panel = new CommandKeysPanel(commands, () -> left[0] = true);
        JTable table = Layout.find(panel, "command-keys-table", JTable.class).orElseThrow();
        KeyStroke escape = KeyStroke.getKeyStroke("ESCAPE");
        int around = JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT;

        SwingUtilities.notifyAction(
                panel.getActionMap().get(panel.getInputMap(around).get(escape)),
                escape,
                new KeyEvent(table, KeyEvent.KEY_PRESSED, 0, 0, KeyEvent.VK_ESCAPE, KeyEvent.CHAR_UNDEFINED),
                panel,
                0);

        assertThat(left[0]).isTrue();
        assertThat(table.getActionMap()
                        .get(table.getInputMap(around).get(escape))
                        .accept(table))
                .as("whether the table keeps the key for itself")
                .isFalse();
    }

    private static void press(CommandSearch search, String key) {
        search.getActionMap().get(key).actionPerformed(null);
    }

    @Test
    void reasonsAreReadToTheirEndInTheSearch() {
        CommandRegistry commands = new CommandRegistry();
        String reason =
                "The transition accepted outside takes tokens from choose inside: select it, too, or leave choose"
                        + " out; so does the transition rejected, which leads back to where locations are created";
        commands.add(
                new Command("net-extract", "Extract to a sub-mission", () -> {}).unless(() -> Optional.of(reason)));
        CommandSearch search = new CommandSearch(commands, () -> {});

        Layout.layOut(search, search.getPreferredSize().width, search.getPreferredSize().height);

        JList<?> list = Layout.find(search, "command-search-found", JList.class).orElseThrow();
        assertThat(list.getWidth()).isLessThanOrEqualTo(search.getWidth());
        assertThat(TextFit.faults(search)).isEmpty();
        assertThat(list.getCellBounds(0, 0).height).isGreaterThan(Look.px(Spacing.HIT_TARGET) + 12);
    }
}
