package org.sami.crw.gui.boat;

import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.sami.boat.link.BoatCapabilities;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.proxy.explanation.LostLinkWords;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.palette.SemanticColor;
import org.sami.session.api.FrontFleet;
import org.sami.session.api.RefusedException;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.LookColors;

/**
 * The settings of the selected boat: gains of its two loops, velocity multiplier, what it does without a link. Each is set by itself, and says what the boat
 * answered. Gains are locked where the boat says that it takes none, and are not there for what flies.
 */
final class SettingsForm extends JPanel {
    private static final String NOTHING = "nothing is wished";

    private final OperatorContext context;
    private final List<Line> lines = new ArrayList<>();
    private Optional<String> boat = Optional.empty();
    private Optional<BoatTuning> tuning = Optional.empty(); // of the boat that is shown

    /** One setting: fields, a button, what is in force and what came of the last request. */
    private final class Line {
        private final Function<BoatTuning, String> inForce;
        private final Entry entry;
        private final Lock lock;
        private final JLabel label;
        private final JComponent fields;
        private final CommandButton button;
        private boolean filled;
        private final JLabel now = new JLabel("–");
        private final Command command;
        private String answer = "";
        private boolean bad;

        Line(
                String id,
                String title,
                JComponent fields,
                Function<BoatTuning, String> inForce,
                Setting setting,
                Entry entry,
                Lock lock) {
            this.inForce = inForce;
            this.entry = entry;
            this.lock = lock;
            this.fields = fields;
            command = context.commands()
                    .add(new Command("boat-set-" + id, "Set " + title.toLowerCase(Locale.ROOT), () -> set(setting))
                            .withIcon("check")
                            .unless(() -> boat.isPresent()
                                    ? context.whyNotAct().or(() -> whyLocked(tuning))
                                    : Optional.of(context.say("select a boat first"))));
            now.setName("boat-" + id + "-now");
            button = new CommandButton(command);
            button.setText("Set");
            label = new JLabel(context.say(title));
            add(label);
            add(fields, "hmin 40");
            add(button);
            add(now, "wmin 60");
        }

        private void set(Setting setting) {
            String whom = boat.orElseThrow();
            try {
                CompletionStage<Void> asked = setting.ask(context.session().fleet(), whom);
                say("asked…", false);
                asked.whenComplete((taken, fault) -> {
                    if (boat.filter(whom::equals).isPresent()) {
                        say(fault == null ? "✓ taken" : "▲ " + RefusedException.reason(fault), fault != null);
                    }
                    if (fault == null) {
                        context.notices()
                                .show(whom + " took it: " + command.title().toLowerCase(Locale.ROOT));
                    } else {
                        context.notices().refused(RefusedException.reason(fault));
                    }
                });
            } catch (IllegalArgumentException unfit) { // also of a number that is none
                say("▲ " + unfit.getMessage(), true);
            }
        }

        private void say(String text, boolean wrong) {
            answer = context.say(text);
            bad = wrong;
        }

        private Optional<String> whyLocked(Optional<BoatTuning> settings) {
            if (lock == Lock.NONE) {
                return Optional.empty();
            }
            return boat.filter(context::flies).isPresent()
                    ? Optional.of("it flies: its autopilot has gains of its own")
                    : settings.flatMap(known ->
                            Optional.ofNullable(known.capabilities().cannot().get(BoatCapabilities.GAINS)));
        }

        private void enableFields(boolean enabled) {
            for (Component part : fields.getComponents()) {
                part.setEnabled(enabled);
            }
        }

        /** Another boat is shown: what was entered for the one before, and its answer, do not concern it. */
        private void turn() {
            say("", false);
            entry.clear();
            filled = false;
        }

        private void show(Optional<BoatTuning> settings, boolean flies) {
            boolean offered = !flies || lock != Lock.GAINS;
            List.of(label, fields, button, now).forEach(part -> part.setVisible(offered));
            Optional<String> locked = whyLocked(settings);
            if (lock != Lock.NONE) {
                enableFields(locked.isEmpty());
            }
            if (!filled && settings.isPresent() && locked.isEmpty()) {
                entry.fill(settings.get());
                filled = true;
            }
            String text = locked.or(() -> settings.map(inForce).map(value -> "in force: " + value))
                            .orElse("not known")
                    + (answer.isEmpty() ? "" : "   " + answer);
            if (!text.equals(now.getText())) {
                now.setText(text);
                now.setToolTipText(text);
            }
            LookColors.foreground(now, bad ? SemanticColor.CRITICAL : SemanticColor.MUTED);
            command.refresh();
        }
    }

    /** What keeps a boat from taking a setting at all. */
    private enum Lock {
        NONE,
        /** Gains of the loops of a boat; what flies has none of these. */
        GAINS
    }

    /** Asks a boat for a setting. */
    private interface Setting {
        /** @throws IllegalArgumentException if what is entered is no value, in words */
        CompletionStage<Void> ask(FrontFleet fleet, String boat);
    }

    /** What is entered for a setting. */
    private interface Entry {
        /** Enters nothing. */
        void clear();

        /** Enters the value in force, where nothing was typed. */
        void fill(BoatTuning settings);
    }

    /** Numbers that are typed. */
    private record Numbers(List<JTextField> fields, Function<BoatTuning, List<Double>> inForce) implements Entry {
        @Override
        public void clear() {
            fields.forEach(field -> field.setText(""));
        }

        @Override
        public void fill(BoatTuning settings) {
            if (fields.stream().allMatch(field -> field.getText().isBlank())) {
                List<Double> values = inForce.apply(settings);
                for (int i = 0; i < fields.size(); i++) {
                    fields.get(i).setText(number(values.get(i)));
                }
            }
        }
    }

    /** An action that is chosen, once the boat has said which is in force. */
    private record Choice(JComboBox<LostLinkAction> box) implements Entry {
        @Override
        public void clear() {
            box.setSelectedIndex(-1);
        }

        @Override
        public void fill(BoatTuning settings) {
            if (box.getSelectedIndex() < 0) {
                box.setSelectedItem(settings.lostLinkAction());
            }
        }
    }

    /** A wish of the session, which is none of the boat that is shown. */
    private static final class OfSession implements Entry {
        @Override
        public void clear() {
            // it is the same for all boats
        }

        @Override
        public void fill(BoatTuning settings) {
            // no boat says it
        }
    }

    SettingsForm(OperatorContext context) {
        super(new MigLayout(
                "novisualpadding, insets 8 12 8 12, gap 8 4, fillx, hidemode 3, wrap 4", "[][][][grow,fill]"));
        this.context = context;
        setName("boat-settings");
        addGains("heading", "Steering gains", GainAxis.HEADING, BoatTuning::heading);
        addGains("speed", "Driving gains", GainAxis.SPEED, BoatTuning::speed);
        JTextField multiplier = field("boat-velocity", "");
        lines.add(new Line(
                "velocity",
                "Velocity multiplier",
                multiplier,
                settings -> number(settings.velocityMultiplier()),
                (fleet, whom) -> fleet.setVelocityMultiplier(whom, number(multiplier)),
                new Numbers(List.of(multiplier), settings -> List.of(settings.velocityMultiplier())),
                Lock.NONE));
        JComboBox<LostLinkAction> action = actions("boat-lost-link", "What the boat does when its link is lost");
        lines.add(new Line(
                "lost-link",
                "Without a link",
                action,
                settings -> context.say(LostLinkWords.of(settings.lostLinkAction())),
                (fleet, whom) -> fleet.setLostLinkAction(whom, chosen(action)),
                new Choice(action),
                Lock.NONE));
        JComboBox<LostLinkAction> wish = actions("boat-lost-link-wish", "What is wished of all boats without a link");
        wish.insertItemAt(null, 0);
        wish.setSelectedIndex(0);
        lines.add(new Line(
                "lost-link-wish",
                "Wished without a link",
                wish,
                settings -> wished(context.lostLinkWish()),
                (fleet, whom) -> fleet.wishLostLink(Optional.ofNullable(wish.getItemAt(wish.getSelectedIndex()))),
                new OfSession(),
                Lock.NONE));
    }

    private String wished(Optional<LostLinkAction> wish) {
        return wish.map(LostLinkWords::of).map(context::say).orElse(NOTHING);
    }

    private JComboBox<LostLinkAction> actions(String name, String accessible) {
        JComboBox<LostLinkAction> box = new JComboBox<>(LostLinkAction.values());
        box.setName(name);
        box.getAccessibleContext().setAccessibleName(context.say(accessible));
        box.setRenderer((list, value, index, selected, focused) -> {
            JLabel label = new JLabel(value == null ? NOTHING : context.say(LostLinkWords.of(value)));
            label.setOpaque(selected);
            LookColors.background(label, SemanticColor.SELECTION);
            LookColors.foreground(label, selected ? SemanticColor.ON_SELECTION : SemanticColor.TEXT);
            return label;
        });
        return box;
    }

    private void addGains(String id, String title, GainAxis axis, Function<BoatTuning, Gains> of) {
        JTextField p = field("boat-" + id + "-p", "");
        JTextField i = field("boat-" + id + "-i", "");
        JTextField d = field("boat-" + id + "-d", "");
        JPanel fields = new JPanel(new MigLayout("novisualpadding, insets 0, gap 4", "[][][][][][]"));
        fields.setOpaque(false);
        List<Supplier<JComponent>> parts =
                List.of(() -> new JLabel("P"), () -> p, () -> new JLabel("I"), () -> i, () -> new JLabel("D"), () -> d);
        parts.forEach(part -> fields.add(part.get(), part.get() instanceof JTextField ? "hmin 40" : ""));
        lines.add(new Line(
                id,
                title,
                fields,
                settings -> {
                    Gains gains = of.apply(settings);
                    return "P " + number(gains.proportional()) + ", I " + number(gains.integral()) + ", D "
                            + number(gains.derivative());
                },
                (fleet, whom) -> fleet.setGains(whom, axis, new Gains(number(p), number(i), number(d))),
                new Numbers(List.of(p, i, d), settings -> values(of.apply(settings))),
                Lock.GAINS));
    }

    private static List<Double> values(Gains gains) {
        return List.of(gains.proportional(), gains.integral(), gains.derivative());
    }

    private static LostLinkAction chosen(JComboBox<LostLinkAction> box) {
        if (box.getSelectedIndex() < 0) {
            throw new IllegalArgumentException("choose what it does first");
        }
        return box.getItemAt(box.getSelectedIndex());
    }

    private JTextField field(String name, String text) {
        JTextField field = new JTextField(text, 5);
        field.setName(name);
        field.getAccessibleContext().setAccessibleName(context.say(name.replace('-', ' ')));
        return field;
    }

    private static String number(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e6
                ? String.format(Locale.ROOT, "%.0f", value)
                : String.format(Locale.ROOT, "%.3f", value).replaceFirst("0+$", "");
    }

    private static double number(JTextField field) {
        try {
            return Double.parseDouble(field.getText().strip().replace(',', '.'));
        } catch (NumberFormatException unfit) {
            throw new IllegalArgumentException("enter a number, such as 0.5, not '" + field.getText() + "'", unfit);
        }
    }

    /** Shows what is in force on a boat; another one has not been asked for anything yet. */
    void show(Optional<String> which, Optional<BoatTuning> settings) {
        if (!which.equals(boat)) {
            boat = which;
            lines.forEach(Line::turn);
        }
        tuning = settings;
        boolean flies = which.map(context::flies).orElse(context.robots() == RobotKind.COPTER);
        lines.forEach(line -> line.show(settings, flies));
    }
}
