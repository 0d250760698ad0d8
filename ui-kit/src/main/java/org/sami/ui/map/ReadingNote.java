package org.sami.ui.map;

import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.LookColors;

/** Says in a corner of a map what is still being read, with a button that leaves it. What is read quickly is not mentioned. On the event thread. */
final class ReadingNote extends JPanel {
    private static final int QUICK_MS = 500;

    private final transient Supplier<Optional<String>> reading;
    private final transient Command stop;
    private final JLabel text = new JLabel();
    private final Timer late = new Timer(QUICK_MS, e -> present(true));

    /**
     * A note that is not shown.
     *
     * @param reading what is being read, in a few words; empty where nothing is
     * @param stop leaves it
     */
    ReadingNote(Supplier<Optional<String>> reading, Command stop) {
        super(new MigLayout("novisualpadding, insets 4 12 4 4, gap 12", "[grow][]", "[center]"));
        this.reading = reading;
        this.stop = stop;
        setName("map-reading");
        text.setName("map-reading-file");
        late.setRepeats(false);
        CommandButton button = new CommandButton(stop);
        button.setText("Stop");
        button.getAccessibleContext().setAccessibleName(stop.title());
        add(text, "wmin 0");
        add(button);
        setVisible(false);
        LookColors.background(this, SemanticColor.SURFACE);
        LookColors.border(this, () -> BorderFactory.createLineBorder(SemanticColor.BORDER.get()));
    }

    /** Looks whether something is being read. */
    void look() {
        Optional<String> now = reading.get();
        if (now.isEmpty()) {
            late.stop();
            present(false);
        } else if (isVisible()) {
            present(true);
        } else if (!late.isRunning()) {
            late.start();
        }
    }

    private void present(boolean shown) {
        reading.get().ifPresent(what -> {
            text.setText("Reading " + what + "…");
            text.setToolTipText("Reading " + what + "; the map can be used meanwhile");
        });
        if (isVisible() != shown) {
            stop.refresh();
            setVisible(shown);
        }
    }
}
