package org.sami.crw.gui.boat;

import java.util.function.UnaryOperator;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.CommandButton;
import org.sami.ui.value.WrappedText;

/** Drives the selected boat by a stick on the screen, and says how it is done with keys. */
final class ByHandPanel extends JPanel {
    private static final String STICK = "hmin 96";
    private static final String LOW_STICK = "h 96!, top";

    private final Teleoperation teleoperation;
    private final UnaryOperator<String> words;
    private final WrappedText text = new WrappedText("");
    private final StickView stick;

    /** @param words puts the word for the session's robots into a text about boats */
    ByHandPanel(Teleoperation teleoperation, UnaryOperator<String> words) {
        super(new MigLayout("novisualpadding, insets 4 12 4 12, gap 16 8, fill", "[][grow,fill]", "[grow]"));
        this.teleoperation = teleoperation;
        this.words = words;
        setName("boat-hand");
        stick = new StickView(teleoperation, words);
        text.setName("boat-hand-text");
        JPanel side = new JPanel(new MigLayout("novisualpadding, insets 0, gap 0 8, fillx, wrap 1", "[grow,fill]"));
        side.add(new CommandButton(teleoperation.command()), "growx 0");
        side.add(text, "wmin 60");
        add(stick, STICK);
        add(side, "wmin 60");
        teleoperation.addListener(this::drivingChanged);
        refresh();
    }

    private void drivingChanged() {
        if (teleoperation.isStickFree()) {
            stick.letGo();
        }
        refresh();
    }

    /** In a low panel the stick is no higher than the view on it, whatever height the text next to it needs. */
    void setLow(boolean low) {
        ((MigLayout) getLayout()).setComponentConstraints(stick, low ? LOW_STICK : STICK);
        revalidate();
    }

    /** Says what can be done now. */
    void refresh() {
        String now = words.apply(teleoperation
                .driven()
                .map(boat -> "You drive " + boat
                        + ". What missions want of it waits. Arrow keys or the stick; Escape gives it back, and "
                        + "two seconds without this window it stops by itself.")
                .or(() -> teleoperation.whyNot().map(why -> "Nothing is driven: " + why + "."))
                .orElse("Drag the stick, or begin with the button and use the arrow keys. Missions are notified, and"
                        + " what they want of the boat waits until it is given back."));
        if (!now.equals(text.getText())) {
            text.setText(now);
        }
        text.setColor(teleoperation.driven().isPresent() ? SemanticColor.WARNING : SemanticColor.MUTED);
        stick.repaint();
    }
}
