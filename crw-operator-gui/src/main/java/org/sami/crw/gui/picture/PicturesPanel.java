package org.sami.crw.gui.picture;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.picture.PanoramaPictures;
import org.sami.palette.SemanticColor;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRow;
import org.sami.ui.replay.SessionClock;
import org.sami.ui.value.WrappedText;

/** The pictures of the session, one of them large. The newest, unless the operator has turned to another one. */
public final class PicturesPanel extends JPanel {
    private static final String NONE = "none";
    private static final String SOME = "some";
    private static final int MOST_SMALL = 8;

    private final ShownPictures pictures;
    private final CardLayout cards = new CardLayout();
    private final PictureView view;
    private final PictureStrip strip;
    private final WrappedText caption = new WrappedText("");
    private final List<Command> commands = new ArrayList<>();
    private final Runnable toFront;
    private Optional<PictureChoice> shown = Optional.empty();
    private boolean chosen; // by the operator

    /** The pictures of the window's session; another panel opens one here by {@link ShownPictures#open}. */
    public PicturesPanel(OperatorContext context, ShownPictures pictures) {
        this.pictures = pictures;
        setLayout(cards);
        setName("pictures-panel");
        view = new PictureView(pictures);
        strip = new PictureStrip(pictures, 1);
        toFront = () -> context.commands().find("panel-pictures").ifPresent(Command::run);
        add(empty(context), NONE);
        add(some(context), SOME);
        pictures.addListener(this::refresh);
        pictures.onOpen(this::open);
        refresh();
    }

    private static JComponent empty(OperatorContext context) {
        JPanel empty = new JPanel(new MigLayout("insets 16, fill", "[grow,fill]", "[center]"));
        WrappedText text = new WrappedText(
                context.say("No picture yet. What boats take appears here by itself, a few seconds after a panorama is"
                        + " complete."));
        text.setName("pictures-empty");
        text.setColor(SemanticColor.MUTED);
        empty.add(text, "wmin 60");
        return empty;
    }

    private JComponent some(OperatorContext context) {
        JPanel some = new JPanel(new MigLayout(
                "novisualpadding, insets 8 12 8 12, gap 8 6, fill, hidemode 3, wrap 1",
                "[grow,fill]",
                "[][grow,fill][][]"));
        caption.setName("picture-caption");
        CommandRow row = new CommandRow();
        command(context, "picture-previous", "Previous picture", "alt LEFT", "LEFT", "left", () -> step(-1));
        command(context, "picture-next", "Next picture", "alt RIGHT", "RIGHT", "right", () -> step(1));
        command(context, "picture-larger", "Enlarge the picture", "alt EQUALS", "PLUS", "zoom-in", view::larger);
        command(context, "picture-smaller", "Reduce the picture", "alt MINUS", "MINUS", "zoom-out", view::smaller);
        command(context, "picture-fit", "Show the whole picture", "alt Z", "0", "fit", view::fit);
        commands.forEach(command -> row.left(CommandButton.iconOnly(command)));
        some.add(caption, "wmin 60");
        some.add(view, "wmin 0, hmin 60");
        some.add(strip, "wmin 0");
        some.add(row, "wmin 0");
        JPanel around = new JPanel(new BorderLayout());
        around.add(some);
        return around;
    }

    private void command(
            OperatorContext context, String id, String title, String key, String here, String icon, Runnable run) {
        Command command = context.commands()
                .add(new Command(id, title, run)
                        .withKey(key)
                        .withIcon(icon)
                        .unless(() ->
                                shown.isPresent() ? Optional.empty() : Optional.of("no boat has taken a picture yet")));
        commands.add(command);
        view.getInputMap().put(KeyStroke.getKeyStroke(here), id);
        view.getActionMap().put(id, command);
    }

    /** Shows one large, and comes to the front. */
    private void open(PictureChoice choice) {
        chosen = true;
        show(Optional.of(choice));
        toFront.run();
        view.requestFocusInWindow();
    }

    /** From the last picture of a panorama to the first of the next one. */
    private void step(int by) {
        List<PictureChoice> all = new ArrayList<>();
        pictures.all().forEach(each -> all.addAll(PictureChoice.of(each)));
        for (int i = 0; i < all.size(); i++) {
            if (shown.filter(all.get(i)::isSame).isPresent()) {
                chosen = true;
                show(Optional.of(all.get(Math.floorMod(i + by, all.size()))));
                return;
            }
        }
    }

    private void refresh() {
        List<PanoramaPictures> all = pictures.all();
        Optional<PictureChoice> now = shown.filter(one -> chosen)
                .flatMap(one -> all.stream()
                        .filter(each -> each.boat().equals(one.of().boat())
                                && each.panorama().equals(one.of().panorama()))
                        .findFirst()
                        .map(each -> new PictureChoice(each, one.index())))
                .or(() ->
                        all.isEmpty() ? Optional.empty() : Optional.of(new PictureChoice(all.get(all.size() - 1), 0)));
        show(now);
    }

    private void show(Optional<PictureChoice> now) {
        shown = now;
        cards.show(this, now.isPresent() ? SOME : NONE);
        view.show(now);
        strip.show(now.map(PicturesPanel::around).orElse(List.of()));
        strip.mark(now);
        String words = now.map(PicturesPanel::caption).orElse("");
        if (!caption.getText().equals(words)) {
            caption.setText(words);
        }
        commands.forEach(Command::refresh);
    }

    /** Of a panorama with many pictures those next to the one that is shown. */
    private static List<PictureChoice> around(PictureChoice one) {
        List<PictureChoice> all = PictureChoice.of(one.of());
        int from = Math.max(0, Math.min(all.size() - MOST_SMALL, one.index() - MOST_SMALL / 2));
        return all.subList(from, Math.min(all.size(), from + MOST_SMALL));
    }

    private static String caption(PictureChoice one) {
        GeoPoint from = one.of().from();
        String missing =
                one.of().coming() == 0 && one.of().here() == one.of().pictures().size()
                        ? ""
                        : " · " + one.of().words();
        return one.words() + " · taken at "
                + SessionClock.text(one.of().atMillis())
                + String.format(Locale.ROOT, " from %.5f, %.5f", from.latDeg(), from.lonDeg()) + missing;
    }
}
