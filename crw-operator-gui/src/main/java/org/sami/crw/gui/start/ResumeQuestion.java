package org.sami.crw.gui.start;

import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.sami.ui.EventThread;
import org.sami.ui.command.Command;
import org.sami.ui.value.WrappedText;

/** Asks, in a window of its own before the operator's is there, whether a session that was not finished goes on. */
public final class ResumeQuestion {
    private final CompletableFuture<Optional<Boolean>> answer = new CompletableFuture<>();
    private final JFrame frame = new JFrame("SAMI operator");

    private ResumeQuestion(Path journal, Optional<String> trouble) {
        String name = journal.getFileName().toString().replace(".journal", "").replace('_', ' ');
        JPanel panel = new JPanel(new MigLayout("novisualpadding, insets 16, gap 8, fillx, w 480::", "[grow,fill]"));
        WrappedText text = new WrappedText(trouble.map(words -> words + ".\n").orElse("") + "The session of " + name
                + (trouble.isEmpty() ? " was not finished." : " may not have been finished.")
                + " Its missions, decisions and links are in its journal. Escape closes this and leaves it on offer.");
        text.setName("resume-question-text");
        panel.add(text, "span, wmin 60, gapbottom 8");
        JButton goOn = button("resume-go-on", "Go on with it", true);
        panel.add(goOn, "split 2, hmin 40");
        panel.add(button("resume-begin-anew", "Begin a new one", false), "hmin 40");
        panel.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke("ESCAPE"), "leave");
        panel.getActionMap()
                .put("leave", new Command("resume-leave", "Leave it on offer", () -> give(Optional.empty())));
        frame.setName("resume-question");
        frame.setContentPane(panel);
        frame.getRootPane().setDefaultButton(goOn);
        frame.setDefaultCloseOperation(JFrame.DO_NOTHING_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent e) {
                give(Optional.empty());
            }
        });
        frame.pack();
        frame.pack(); // by now the text knows into how many lines it is broken
        frame.setLocationRelativeTo(null);
        frame.setVisible(true);
        goOn.requestFocusInWindow();
    }

    private JButton button(String name, String words, boolean goesOn) {
        JButton button = new JButton(words);
        button.setName(name);
        button.addActionListener(e -> give(Optional.of(goesOn)));
        return button;
    }

    private void give(Optional<Boolean> given) {
        frame.dispose();
        answer.complete(given);
    }

    /**
     * Asks, and waits for the answer; empty where the question was closed without one. Not for the event thread.
     *
     * @param trouble why it is not known for sure that the session was not finished, one sentence without a full stop; empty where it is
     */
    public static Optional<Boolean> ask(Path journal, Optional<String> trouble) {
        return EventThread.get(() -> new ResumeQuestion(journal, trouble))
                .answer
                .join();
    }
}
