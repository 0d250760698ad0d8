package org.sami.dreamm;

import static java.awt.event.KeyEvent.VK_A;
import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_ENTER;

import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JSpinner;
import javax.swing.JTextField;
import javax.swing.text.JTextComponent;
import org.sami.spn.model.Action;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TokenKind;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.value.ValueSummary;

/** Works in the inspector of the window that is open, on what is selected in the net. */
final class InspectorGestures {
    private static final InRequirement IMPLIED_IN = InRequirement.of(TokenKind.GENERIC, Match.AT_LEAST, 1);
    private static final OutRequirement IMPLIED_OUT = OutRequirement.of(Action.TAKE, 1, TokenKind.GENERIC);
    private static final int MOST_STEPS = 30;

    private final WindowRobot robot;

    InspectorGestures(WindowRobot robot) {
        this.robot = robot;
    }

    // ---- Vertices

    /** Writes the name of the vertex that is selected. */
    void name(String name) {
        JTextField field = robot.find(JTextField.class, "inspector-name");
        write(field, name);
    }

    /** Ticks a box, or takes its tick away. */
    void tick(String name) {
        AbstractButton box = robot.find(AbstractButton.class, name);
        robot.scrollTo(box);
        robot.click(name);
    }

    private void write(JTextComponent field, String text) {
        robot.scrollTo(field);
        robot.click(field);
        robot.until("the text " + field.getName() + " is being written", field::isFocusOwner);
        robot.press(VK_A, VK_CONTROL);
        robot.type(text);
        robot.press(VK_ENTER);
    }

    // ---- Requirements

    /** Makes the requirements of the edge to a transition that is selected so. */
    void requireIn(List<InRequirement> wanted, Supplier<List<InRequirement>> now) {
        for (int step = 0; step < MOST_STEPS; step++) {
            List<InRequirement> there = now.get();
            if (same(there, wanted)) {
                return;
            }
            if (there.contains(IMPLIED_IN) != wanted.contains(IMPLIED_IN)) {
                change(now, () -> tick("inspector-implied-generic"));
                continue;
            }
            int row = firstOdd(there, wanted, IMPLIED_IN);
            Optional<InRequirement> missing =
                    wanted.stream().filter(each -> !there.contains(each)).findFirst();
            if (row < 0) {
                change(now, () -> robot.click("inspector-add-requirement"));
            } else if (missing.isEmpty()) {
                change(now, () -> robot.click("inspector-remove-requirement-" + row));
            } else {
                change(now, () -> begin(row, there.get(row), missing.get()));
            }
        }
        throw new AssertionError("the edge does not come to ask for " + wanted + ", but for " + now.get());
    }

    /** The first difference: that of the kind last where the kind alone would make it the implied one. */
    private void begin(int row, InRequirement from, InRequirement to) {
        boolean kindLast = to.kind() == TokenKind.GENERIC;
        if (from.kind() != to.kind() && (!kindLast || (from.match() == to.match() && from.n() == to.n()))) {
            robot.choose("inspector-kind-" + row, words(to.kind(), "No Condition"));
        } else if (from.match() != to.match()) {
            robot.choose("inspector-match-" + row, words(to.match()));
        } else if (from.n() != to.n()) {
            count(row, to.n());
        } else {
            robot.choose("inspector-kind-" + row, words(to.kind(), "No Condition"));
        }
    }

    /** Makes the requirements of the edge to a place that is selected so. */
    void requireOut(List<OutRequirement> wanted, Supplier<List<OutRequirement>> now) {
        for (int step = 0; step < MOST_STEPS; step++) {
            List<OutRequirement> there = now.get();
            if (same(there, wanted)) {
                return;
            }
            if (there.contains(IMPLIED_OUT) != wanted.contains(IMPLIED_OUT)) {
                change(now, () -> tick("inspector-implied-generic"));
                continue;
            }
            int row = firstOdd(there, wanted, IMPLIED_OUT);
            Optional<OutRequirement> missing =
                    wanted.stream().filter(each -> !there.contains(each)).findFirst();
            if (row < 0) {
                change(now, () -> robot.click("inspector-add-requirement"));
            } else if (missing.isEmpty()) {
                change(now, () -> robot.click("inspector-remove-requirement-" + row));
            } else {
                change(now, () -> begin(row, there.get(row), missing.get()));
            }
        }
        throw new AssertionError("the edge does not come to do " + wanted + ", but " + now.get());
    }

    private void begin(int row, OutRequirement from, OutRequirement to) {
        boolean kindLast = to.kind() == TokenKind.GENERIC;
        boolean rest = from.action() == to.action() && from.n() == to.n();
        if (from.kind() != to.kind() && (!kindLast || rest)) {
            robot.choose("inspector-kind-" + row, words(to.kind(), "Enter With Nobody"));
        } else if (from.action() != to.action()) {
            robot.choose("inspector-action-" + row, words(to.action()));
        } else if (from.takesAll() != to.takesAll()) {
            robot.choose("inspector-quantity-" + row, to.takesAll() ? "All" : "n");
        } else if (from.n() != to.n()) {
            count(row, to.n());
        }
    }

    private static <R> boolean same(List<R> there, List<R> wanted) {
        return there.size() == wanted.size() && there.containsAll(wanted);
    }

    /** The first requirement that is not wanted and has a row; -1 where there is none. */
    private static <R> int firstOdd(List<R> there, List<R> wanted, R implied) {
        for (int i = 0; i < there.size(); i++) {
            if (!wanted.contains(there.get(i)) && !there.get(i).equals(implied)) {
                return i;
            }
        }
        return -1;
    }

    private <R> void change(Supplier<List<R>> now, Runnable gesture) {
        List<R> before = now.get();
        gesture.run();
        robot.until(
                "the requirements are others than " + before, () -> !now.get().equals(before));
    }

    private void count(int row, int n) {
        JSpinner spinner = robot.find(JSpinner.class, "inspector-count-" + row);
        JTextField field = WindowRobot.ask(() -> ((JSpinner.DefaultEditor) spinner.getEditor()).getTextField());
        write(field, Integer.toString(n));
    }

    private static String words(Match match) {
        return switch (match) {
            case ZERO -> "No";
            case LESS_THAN -> "<";
            case AT_LEAST -> "≥";
            case EXACTLY -> "=";
            case ALL -> "All";
        };
    }

    private static String words(Action action) {
        return switch (action) {
            case TAKE -> "Take";
            case CONSUME -> "Consume";
            case ADD -> "Add";
        };
    }

    private static String words(TokenKind kind, String unconditional) {
        return switch (kind) {
            case GENERIC -> "Generic";
            case ANY_PROXY -> "Proxy";
            case ANY_TASK -> "Task";
            case ANY_TOKEN -> "Token";
            case TASK -> "named Task";
            case RELEVANT -> "Relevant";
            case SUB_MISSION_TOKENS -> "Sub-mission";
            case UNCONDITIONAL -> unconditional;
        };
    }

    // ---- Events

    /** The name of the components of a field. */
    static String field(String name) {
        return "field-" + kebab(name);
    }

    private static String kebab(String name) {
        return name.replaceAll("([a-z0-9])([A-Z])", "$1-$2")
                .toLowerCase(Locale.ROOT)
                .replaceAll("[^a-z0-9]+", "-");
    }

    /** Chooses what a box of an event says. */
    void choose(int event, String box, String words) {
        robot.choose(in(event, JComboBox.class, box), words);
    }

    /** The words that a box of an event offers. */
    List<String> offered(int event, String box) {
        JComboBox<?> found = in(event, JComboBox.class, box);
        return WindowRobot.ask(() -> {
            List<String> words = new ArrayList<>();
            for (int i = 0; i < found.getItemCount(); i++) {
                words.add(shown(found, i));
            }
            return words;
        });
    }

    private static <T> String shown(JComboBox<T> box, int i) {
        Component cell = box.getRenderer()
                .getListCellRendererComponent(new javax.swing.JList<>(), box.getItemAt(i), i, false, false);
        return cell instanceof javax.swing.JLabel label ? label.getText() : "";
    }

    private <C extends JComponent> C in(int event, Class<C> type, String name) {
        C found = robot.find(type, each -> name.equals(each.getName()) && NetGestures.isIn("event-" + event, each));
        robot.scrollTo(found);
        return found;
    }

    /** Gives a field of an event a value in its editor. */
    void value(int event, String field, Value value) {
        if (value instanceof EnumValue || hasChoice(event, field)) {
            String words = value instanceof TextValue text ? text.value() : ValueSummary.of(value);
            choose(event, field(field) + "-value", words);
        } else {
            write(in(event, JTextField.class, "value-" + kebab(field) + "-text"), text(value));
        }
    }

    private static boolean hasChoice(int event, String field) {
        return WindowRobot.ask(() -> anywhere(event, field(field) + "-value"));
    }

    private static boolean anywhere(int event, String name) {
        for (java.awt.Window window : java.awt.Window.getWindows()) {
            if (window.isShowing() && below(window, event, name)) {
                return true;
            }
        }
        return false;
    }

    private static boolean below(Component at, int event, String name) {
        if (name.equals(at.getName()) && at.isShowing() && NetGestures.isIn("event-" + event, at)) {
            return true;
        }
        if (at instanceof java.awt.Container container) {
            for (Component child : container.getComponents()) {
                if (below(child, event, name)) {
                    return true;
                }
            }
        }
        return false;
    }

    /** A value as it is typed: without signs for which keyboards differ. */
    private static String text(Value value) {
        if (value instanceof DurationValue duration) {
            return duration.millis() / 1000 + " s";
        }
        return ValueSummary.of(value).replaceAll("[^A-Za-z0-9. ]", "");
    }

    // ---- Markup

    /** Adds a markup to an event. */
    void addMarkup(int event, String label) {
        choose(event, "event-add-markup", label);
    }

    /** Chooses the value of an option of a markup. */
    void option(int event, String markup, String option, Value value) {
        String editor = "value-" + kebab(markup + "." + option);
        if (value instanceof EnumValue) {
            String words = ValueSummary.of(value);
            in(event, JComponent.class, editor); // its list has a scroll pane of its own
            robot.click(robot.find(
                    AbstractButton.class,
                    each -> NetGestures.isIn("event-" + event, each)
                            && each.getName() != null
                            && each.getName().startsWith(editor + "-option-")
                            && words.equals(each.getText())));
        } else {
            write(in(event, JTextField.class, editor + "-text"), text(value));
        }
    }

    /** Presses the button that adds a markup whose options are chosen. */
    void confirmMarkup(int event, String markup) {
        robot.click(in(event, AbstractButton.class, "markup-" + kebab(markup) + "-add"));
    }
}
