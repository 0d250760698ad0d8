package org.sami.dreamm.learn.show;

import javax.swing.BorderFactory;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRow;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.StrongLabel;
import org.sami.ui.value.WrappedText;

/** What is said of the edit that is shown, and the buttons that play and stop. */
final class ShowBar extends JPanel {
    private final StrongLabel title = new StrongLabel("");
    private final WrappedText sentence = new WrappedText("");
    private final CommandButton play;

    ShowBar(ShowCommands commands) {
        super(new MigLayout("novisualpadding, insets 12, gap 0 6, wrap 1, fillx, hidemode 3", "[grow, fill]"));
        setName("show-bar");
        LookColors.background(this, SemanticColor.SURFACE_RAISED);
        LookColors.border(this, () -> BorderFactory.createLineBorder(SemanticColor.ACCENT.get(), Look.px(2)));
        title.setName("show-title");
        sentence.setName("show-sentence");
        play = new CommandButton(commands.play());
        add(title, "wmin 0");
        add(sentence, "wmin 0");
        CommandRow row = new CommandRow()
                .left(new CommandButton(commands.back()))
                .left(play)
                .left(new CommandButton(commands.forward()))
                .right(new CommandButton(commands.speed()))
                .right(new CommandButton(commands.stop()));
        row.setName("show-buttons");
        row.setOpaque(false);
        add(row, "wmin 0");
    }

    /** Gives the button that plays the focus. */
    void focus() {
        play.requestFocusInWindow();
    }

    /** Shows where the model is. */
    void show(ShowMeModel model) {
        title.setText(model.title());
        sentence.setText(model.sentence());
        revalidate();
    }
}
