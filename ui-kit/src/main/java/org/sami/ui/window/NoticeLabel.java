package org.sami.ui.window;

import java.util.Optional;
import java.util.function.LongSupplier;
import javax.swing.JLabel;
import javax.swing.Timer;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Icons;
import org.sami.ui.look.LookColors;
import org.sami.ui.window.Notices.Notice;

/** The line with the result of the last command, for as long as it is news. Its component name is {@code notice}. On the event thread. */
public final class NoticeLabel extends JLabel {
    private final transient ShownNotice shown;
    private transient Optional<SemanticColor> ink = Optional.empty();
    private final transient Timer leaves = new Timer(0, e -> refresh());

    /**
     * The line of a window.
     *
     * @param notices of that window
     * @param nanos a clock that only goes on, in ns
     */
    public NoticeLabel(Notices notices, LongSupplier nanos) {
        shown = new ShownNotice(nanos);
        leaves.setRepeats(false);
        setName("notice");
        notices.addListener(told -> {
            shown.tell(told);
            refresh();
        });
        refresh();
    }

    /** From now on all is written in this colour, as what is behind the line has another one than usual; empty = as usual. */
    public void setInk(Optional<SemanticColor> color) {
        if (!ink.equals(color)) {
            ink = color;
            refresh();
        }
    }

    /** Shows what is news now; asked again when it is none any longer. */
    void refresh() {
        Optional<Notice> now = shown.now();
        String text = now.map(Notice::text).orElse("");
        boolean refused = now.filter(Notice::refused).isPresent();
        setText(text);
        setToolTipText(now.isPresent() ? text : null);
        getAccessibleContext().setAccessibleName((refused ? "Refused: " : "") + text);
        setIcon(
                now.isEmpty()
                        ? null
                        : Icons.of(
                                refused ? "alarm" : "check",
                                16,
                                ink.orElse(refused ? SemanticColor.WARNING : SemanticColor.OK)));
        LookColors.foreground(this, ink.orElse(refused ? SemanticColor.WARNING : SemanticColor.MUTED));
        if (now.isPresent()) {
            leaves.setInitialDelay(Math.toIntExact(shown.leftMillis()));
            leaves.restart();
        }
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setFont(Fonts.text());
    }
}
