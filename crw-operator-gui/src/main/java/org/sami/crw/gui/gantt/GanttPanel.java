package org.sami.crw.gui.gantt;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JViewport;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRow;
import org.sami.ui.look.FoldingPanel;
import org.sami.ui.look.LookColors;
import org.sami.ui.value.WrappedText;

/**
 * The missions over time: a line for each, below it its phases with their actions, and its robots with where each was. It goes on by itself; it shows all of the time of the
 * missions that run, or the last minutes. A line of a robot that is chosen selects the robot.
 */
public final class GanttPanel extends JPanel {
    private static final String NONE = "none";
    private static final String SOME = "some";
    private static final int LOW = 190;

    private final OperatorContext context;
    private final GanttLines lines = new GanttLines();
    private final GanttSpan span = new GanttSpan();
    private final GanttView view;
    private final CardLayout cards = new CardLayout();
    private final JLabel shown = new JLabel(" ");
    private final List<Command> commands;
    private List<GanttLine> now = List.of();
    private String chosen = "";

    /** The chart of a session. */
    public GanttPanel(OperatorContext context) {
        this.context = context;
        setLayout(cards);
        setName("gantt-panel");
        view = new GanttView(context.marks());
        commands = List.of(
                add(
                                "gantt-fold",
                                "Open or close the line of the chart",
                                "alt shift F",
                                "down",
                                this::fold,
                                "ENTER",
                                "SPACE")
                        .unless(() -> line().flatMap(GanttLine::open).isPresent()
                                ? Optional.empty()
                                : Optional.of("choose the line of a mission or a phase in the Gantt chart")),
                add(
                        "gantt-less",
                        "Less time in the chart",
                        "ctrl shift EQUALS",
                        "zoom-in",
                        () -> zoom(true),
                        "PLUS",
                        "ADD"),
                add(
                        "gantt-more",
                        "More time in the chart",
                        "ctrl shift MINUS",
                        "zoom-out",
                        () -> zoom(false),
                        "MINUS",
                        "SUBTRACT"),
                add("gantt-all", "All of the missions' time in the chart", "ctrl shift HOME", "fit", this::all, "0"));
        add(empty(), NONE);
        add(some(), SOME);
        context.models().gantt().addListener(missions -> changed());
        changed();
    }

    private Command add(String id, String title, String key, String icon, Runnable run, String... here) {
        Command command =
                context.commands().add(new Command(id, title, run).withKey(key).withIcon(icon));
        for (String each : here) {
            view.getInputMap().put(KeyStroke.getKeyStroke(each), id);
        }
        view.getActionMap().put(id, command);
        return command;
    }

    private JComponent empty() {
        JPanel empty = new JPanel(new MigLayout("insets 16, fill", "[grow,fill]", "[center]"));
        WrappedText text = new WrappedText(
                context.say("No mission has run yet. Each appears here over time: its phases with what is done in them,"
                        + " and where each of its boats is."));
        text.setName("gantt-empty");
        text.setColor(SemanticColor.MUTED);
        empty.add(text, "wmin 60");
        return empty;
    }

    private JComponent some() {
        JScrollPane scroll = new JScrollPane(view);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        scroll.setName("gantt-scroll");
        scroll.getViewport().setScrollMode(JViewport.SIMPLE_SCROLL_MODE); // the axis stays where it is
        FoldingPanel some = new FoldingPanel(new BorderLayout());
        CommandRow row = new CommandRow();
        some.foldBelowHeight(LOW, low -> row.setVisible(!low)); // keys and wheel are left
        commands.forEach(command -> row.left(CommandButton.iconOnly(command)));
        shown.setName("gantt-shown");
        LookColors.foreground(shown, SemanticColor.MUTED);
        row.left(shown);
        some.add(scroll);
        some.add(row, BorderLayout.SOUTH);
        MouseAdapter mouse = new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                view.requestFocusInWindow();
                int line = view.lineAt(e.getY());
                if (line >= 0) {
                    boolean again = now.get(line).id().equals(chosen);
                    choose(line);
                    if (again || e.getClickCount() == 2) {
                        fold();
                    }
                }
            }
        };
        view.addMouseListener(mouse);
        view.addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent e) {
                if (index() < 0 && !now.isEmpty()) {
                    choose(0);
                }
            }
        });
        key(KeyEvent.VK_DOWN, () -> choose(index() + 1));
        key(KeyEvent.VK_UP, () -> choose(index() - 1));
        key(KeyEvent.VK_HOME, () -> choose(0));
        key(KeyEvent.VK_END, () -> choose(now.size() - 1));
        key(KeyEvent.VK_RIGHT, () -> fold(true));
        key(KeyEvent.VK_LEFT, () -> fold(false));
        return some;
    }

    private void key(int code, Runnable run) {
        String id = "gantt-key-" + code;
        new Command(id, id, run)
                .withFocusKeys(List.of(KeyStroke.getKeyStroke(code, 0)))
                .bindTo(view);
    }

    private int index() {
        for (int i = 0; i < now.size(); i++) {
            if (now.get(i).id().equals(chosen)) {
                return i;
            }
        }
        return -1;
    }

    private Optional<GanttLine> line() {
        int index = index();
        return index < 0 ? Optional.empty() : Optional.of(now.get(index));
    }

    private void choose(int line) {
        if (now.isEmpty()) {
            return;
        }
        int index = Math.max(0, Math.min(now.size() - 1, line));
        chosen = now.get(index).id();
        now.get(index).robot().ifPresent(robot -> context.boats().select(List.of(robot)));
        draw();
        view.reveal(index);
        commands.forEach(Command::refresh);
    }

    private void fold() {
        line().ifPresent(lines::toggle);
        changed();
    }

    private void fold(boolean open) {
        line().filter(one -> one.open().map(is -> is != open).orElse(false)).ifPresent(one -> fold());
    }

    private void zoom(boolean in) {
        span.zoom(in);
        draw();
    }

    private void all() {
        span.all();
        draw();
    }

    private void changed() {
        lines.show(context.models().gantt().snapshot());
        now = lines.lines();
        cards.show(this, now.isEmpty() ? NONE : SOME);
        draw();
        commands.forEach(Command::refresh);
    }

    private void draw() {
        long moment = context.nowMillis();
        view.show(now, index(), span.axis(lines.start(), lines.end(), moment, view.timeWidth()), moment);
        String words = "Shown: " + span.words();
        if (!shown.getText().equals(words)) {
            shown.setText(words);
        }
    }

    /** Goes on with the time; to be called a few times a second. */
    public void refresh() {
        if (isShowing() && !now.isEmpty()) {
            draw();
        }
    }
}
