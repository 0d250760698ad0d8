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

/** A row below all panels: what is said of the edit that is shown, and the buttons that play and stop. */
final class ShowBar extends JPanel {
    private final StrongLabel title = new StrongLabel("");
    private final WrappedText sentence = new WrappedText("");
    private final CommandButton play;

    ShowBar(ShowCommands commands) {
        super(new MigLayout(
                "novisualpadding, insets 8 16 8 8, gap 8 4, fillx", "[52%, fill][48%, fill]", "[][grow, top]"));
        setName("show-bar");
        LookColors.background(this, SemanticColor.SURFACE_RAISED);
        LookColors.border(this, () -> BorderFactory.createMatteBorder(Look.px(2), 0, 0, 0, SemanticColor.ACCENT.get()));
        title.setName("show-title");
        sentence.setName("show-sentence");
        play = new CommandButton(commands.play());
        CommandRow row = new CommandRow()
                .left(new CommandButton(commands.back()))
                .left(play)
                .left(new CommandButton(commands.forward()))
                .right(new CommandButton(commands.speed()))
                .right(new CommandButton(commands.stop()));
        row.setName("show-buttons");
        row.setOpaque(false);
        add(title, "wmin 0");
        add(row, "wmin 0, spany 2, aligny center, wrap");
        add(sentence, "wmin 0");
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
