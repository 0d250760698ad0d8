package org.sami.crw.gui.remote;

import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.session.client.PersonRights;
import org.sami.session.client.RemoteListener;
import org.sami.session.client.SessionAddress;
import org.sami.ui.EventThread;
import org.sami.ui.look.LookColors;
import org.sami.ui.window.Notices;

/**
 * Says whose session a window shows, and whether the connection to it stands: in the colour of warnings while what the window shows is as it was seen last. What other people
 * do becomes a notice. On the event thread, but what it listens to.
 */
public final class ConnectionBand extends JPanel implements RemoteListener {
    private final JLabel words = new JLabel();
    private String person = "";
    private String base = "";
    private Optional<String> trouble = Optional.empty();
    private Optional<Notices> notices = Optional.empty();
    private Runnable otherRights = () -> {};
    private Consumer<String> otherBase = address -> {};

    /** A band that says nothing yet. */
    public ConnectionBand() {
        super(new MigLayout("insets 4 12 4 12, gap 0, fillx", "[grow]", "[]"));
        setName("connection-band");
        words.setName("connection");
        add(words, "wmin 0, growx");
        showNow();
    }

    /**
     * Says from now on whose session it is.
     *
     * @param onOtherRights is run on the event thread when the person's role is another one
     * @param onOtherBase is given there the address of another base that holds the session now
     */
    void of(String address, String who, Notices of, Runnable onOtherRights, Consumer<String> onOtherBase) {
        otherRights = onOtherRights;
        otherBase = onOtherBase;
        base = address;
        person = who;
        notices = Optional.of(of);
        showNow();
    }

    private void showNow() {
        LookColors.background(this, trouble.isPresent() ? SemanticColor.WARNING_FILL : SemanticColor.SURFACE_RAISED);
        LookColors.foreground(words, trouble.isPresent() ? SemanticColor.ON_WARNING : SemanticColor.MUTED);
        String whose = base.isEmpty() ? "" : "Session at " + base + ", as " + person;
        words.setText(whose + trouble.map(text -> ": ▲ " + text).orElse(""));
        words.setToolTipText(words.getText());
        getAccessibleContext().setAccessibleName(words.getText());
        repaint();
    }

    private void set(Optional<String> now) {
        EventThread.later(() -> {
            trouble = now;
            showNow();
        });
    }

    @Override
    public void lost(String text) {
        set(Optional.of(text));
    }

    @Override
    public void back(SessionAddress at) {
        EventThread.later(() -> {
            boolean other = !base.isEmpty() && !at.toString().equals(base);
            trouble = Optional.empty();
            if (other) {
                base = at.toString();
                otherBase.accept(base);
            }
            showNow();
            String where = other ? ", at another base, " + at : "";
            notices.ifPresent(one -> one.show("Connected again" + where + ": what is shown is of now"));
        });
    }

    @Override
    public void ended(String why) {
        set(Optional.of(why + "; nothing here is of now, close the window"));
    }

    @Override
    public void rights(PersonRights now) {
        EventThread.later(() -> otherRights.run());
        news("Your role in this session is " + now.role() + " now");
    }

    @Override
    public void news(String text) {
        EventThread.later(() -> notices.ifPresent(one -> one.show(text)));
    }
}
