package org.sami.crw.gui.mission;

import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.mission.InterruptChoice;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Icons;
import org.sami.ui.look.Spacing;

/** The button of one interrupt of one mission, and next to it the one that withdraws it while it asks for its boats. */
final class InterruptRow extends JPanel {
    private static final int MOST_NAMED = 2; // the tooltip has all of them

    private final transient OperatorContext context;
    private final transient InterruptPress press;
    private final JButton button = new JButton();
    private final JButton withdraw = new JButton("Withdraw", Icons.normal("undo"));
    private transient Optional<InterruptChoice> choice = Optional.empty();

    InterruptRow(OperatorContext context, InterruptPress press, String name) {
        super(new MigLayout("novisualpadding, insets 0, gap 4, fillx, hidemode 3", "[grow,fill][]"));
        this.context = context;
        this.press = press;
        setOpaque(false);
        button.setName(name);
        button.setHorizontalAlignment(JButton.LEADING);
        button.addActionListener(
                e -> choice.filter(now -> press.whyNot(now).isEmpty()).ifPresent(press::press));
        withdraw.setName(name + "-withdraw");
        withdraw.addActionListener(e -> choice.ifPresent(press::withdraw));
        withdraw.setVisible(false);
        String high = "hmin " + Spacing.HIT_TARGET_FIELD;
        add(button, high + ", wmin 0");
        add(withdraw, high);
    }

    /** Shows how its interrupt stands now. */
    void show(InterruptChoice now, String key, String withdrawKey) {
        choice = Optional.of(now);
        List<String> boats = press.boats(now);
        String whom = press.whom(now);
        String brief = boats.size() > MOST_NAMED ? context.say(" for " + boats.size() + " boats") : whom;
        boolean asks = now.isFinal() && !brief.endsWith("…");
        button.setText(now.name() + brief + (asks ? "…" : ""));
        button.setIcon(now.isFinal() ? Icons.of("interrupt", 20, SemanticColor.CRITICAL) : Icons.normal("interrupt"));
        Optional<String> whyNot = press.whyNot(now);
        button.setEnabled(whyNot.isEmpty());
        String title = press.title(now);
        String does = boats.isEmpty() && now.asksForBoats()
                ? "Press " + title + context.say("; you are asked for which boats")
                : "Press " + title + whom;
        String undo =
                now.isFinal() ? ". It cannot be undone, and is confirmed first: " + context.say(now.noWayBack()) : "";
        button.setToolTipText(
                whyNot.map(why -> title + ": " + why).orElse(does + undo) + (key.isEmpty() ? "" : " (" + key + ")"));
        button.getAccessibleContext().setAccessibleName(title + whom);
        withdraw.setVisible(now.asking().isPresent() && press.canWithdraw());
        withdraw.setToolTipText("Withdraw " + title + ": nothing is done (" + withdrawKey + ")");
        withdraw.getAccessibleContext().setAccessibleName("Withdraw " + title);
    }

    /** Brings the focus to the button. */
    void focus() {
        button.requestFocusInWindow();
    }
}
