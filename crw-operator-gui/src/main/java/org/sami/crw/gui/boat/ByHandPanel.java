package org.sami.crw.gui.boat;

import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.SemanticColor;
import org.sami.ui.value.WrappedText;

/** Drives the selected boat by a stick on the screen, and says how it is done with keys. */
final class ByHandPanel extends JPanel {
    private final Teleoperation teleoperation;
    private final WrappedText text = new WrappedText("");
    private final StickView stick;

    ByHandPanel(Teleoperation teleoperation) {
        super(new MigLayout("novisualpadding, insets 8 12 8 12, gap 16 8, fill", "[][grow,fill]", "[grow,center]"));
        this.teleoperation = teleoperation;
        setName("boat-hand");
        stick = new StickView(teleoperation::steer, teleoperation::whyNot);
        text.setName("boat-hand-text");
        JPanel side = new JPanel(new MigLayout("novisualpadding, insets 0, gap 0 8, fillx, wrap 1", "[grow,fill]"));
        side.add(text, "wmin 60");
        side.add(new CommandButton(teleoperation.command()), "growx 0");
        add(stick, "hmin 96");
        add(side, "wmin 60");
        teleoperation.addListener(this::refresh);
        refresh();
    }

    /** Says what can be done now. */
    void refresh() {
        String words = teleoperation
                .driven()
                .map(boat -> "You drive " + boat
                        + ". What missions want of it waits. Arrow keys or the stick; Escape gives it back, and "
                        + "two seconds without this window it stops by itself.")
                .or(() -> teleoperation.whyNot().map(why -> "Nothing is driven: " + why + "."))
                .orElse(
                        "Drag the stick, or begin with the button and use the arrow keys. Missions are told, and what they want of the "
                                + "boat waits until it is given back.");
        if (!words.equals(text.getText())) {
            text.setText(words);
        }
        text.setColor(teleoperation.driven().isPresent() ? SemanticColor.WARNING : SemanticColor.MUTED);
        stick.repaint();
    }
}
