package org.sami.crw.gui.file;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.boat.BoatNameColumn;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.session.file.LogFetch;
import org.sami.crw.session.file.LogRow;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandButton;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;
import org.sami.ui.table.TableFit;
import org.sami.ui.value.WrappedText;

/** The form that fetches boats' logs: which boats, which folder, progress and result. A fetch continues while the form is closed. On the event thread. */
final class LogsForm extends JPanel {
    private static final String WIDE = "growx, wmin 60";
    private static final String EMPTY = "No boat is connected. Connect a boat first (Ctrl+B).";
    private static final int LINKS_MS = 1000; // how often boats are looked for that have come or gone
    private static final int LEAST_PX = 80;
    private static final int LEAST_ROWS = 3;

    private final MigLayout layout = new MigLayout(
            "novisualpadding, insets 4 12 12 12, gap 8, fillx, wrap 1, hidemode 3, w 760::",
            "[grow,fill]",
            "[][grow,fill][][][]");
    private final OperatorContext context;
    private final LogFetch fetch;
    private final RowTable<LogRow> table;
    private final JTextField folder = new JTextField(40);
    private final WrappedText hint;
    private final WrappedText said = new WrappedText("");
    private final Command begin;
    private final Command cancel;
    private final Timer look = new Timer(LINKS_MS, e -> look());
    private final LinkQuestion links;
    private String noLinks = ""; // why the boats are not known
    private final TableFit tableFit;

    /**
     * A view of a fetch.
     *
     * @param choose lets the operator choose a folder
     */
    LogsForm(OperatorContext context, LogFetch fetch, Path offered, Consumer<Path> choose) {
        setLayout(layout);
        this.context = context;
        this.fetch = fetch;
        hint = new WrappedText(
                context.say("Logs of all boats are fetched, or of those that are selected. Commands go first: a fetch"
                        + " slows none, also during a mission."));
        links = new LinkQuestion(() -> context.session().fleet().linkedBoats(), fetch::offer, this::linksUnknown);
        setName("logs-form");
        table = new RowTable<>(
                "logs-table",
                context.say(EMPTY),
                LogRow::address,
                List.of(
                        BoatNameColumn.names(context, LogRow::boat),
                        RowColumn.<LogRow>words(
                                        "Address", 150, row -> row.address().toString())
                                .keepingEnds()
                                .asSpare(),
                        RowColumn.<LogRow>words("Its logs", 0, row -> context.say(words(row)))
                                .colored(LogsForm::color)));
        folder.setName("logs-folder");
        folder.setText(offered.toString());
        said.setName("logs-said");
        hint.setName("logs-hint");
        hint.setColor(SemanticColor.MUTED);
        begin = new Command("logs-begin", "Fetch", this::begin).withIcon("file").unless(this::whyNotBegin);
        cancel = new Command("logs-cancel", "Cancel", fetch::cancel)
                .withIcon("close")
                .unless(() -> fetch.isRunning() ? Optional.empty() : Optional.of("nothing is fetched"));
        add(hint, WIDE);
        add(table, "growx");
        tableFit = new TableFit(this, layout, table, LEAST_PX, LEAST_ROWS);
        add(folders(choose), WIDE);
        add(buttons(), WIDE);
        add(said, WIDE);
        folder.addActionListener(e -> begin.run());
        table.table().getInputMap(JComponent.WHEN_FOCUSED).put(KeyStroke.getKeyStroke("ENTER"), "fetch");
        table.table().getActionMap().put("fetch", begin);
        addHierarchyListener(event -> {
            if (isShowing()) {
                links.begin();
                look.start();
            } else {
                look.stop();
            }
        });
        refresh();
    }

    private JPanel folders(Consumer<Path> choose) {
        JPanel row = new JPanel(new MigLayout("novisualpadding, insets 0, gap 8, fillx", "[][grow,fill][]", "[40!]"));
        row.setOpaque(false);
        JLabel label = new JLabel("Into the folder");
        label.setLabelFor(folder);
        row.add(label);
        row.add(folder, "growy, wmin 60");
        row.add(
                new CommandButton(
                        new Command("logs-choose", "Choose…", () -> choose.accept(folder().orElse(Path.of(""))))
                                .withIcon("folder")),
                "growy");
        return row;
    }

    private JPanel buttons() {
        JPanel row = new JPanel(new MigLayout("novisualpadding, insets 0, gap 8", "[][]push", "[40!]"));
        row.setOpaque(false);
        CommandButton first = CommandButton.primary(begin, "file");
        first.getInputMap(JComponent.WHEN_FOCUSED).put(KeyStroke.getKeyStroke("ENTER"), "press");
        first.getActionMap().put("press", begin);
        row.add(first, "growy");
        row.add(new CommandButton(cancel), "growy");
        return row;
    }

    private static String words(LogRow row) {
        return switch (row.state()) {
            case HERE -> "✓ " + row.words();
            case FAILED, NO_ANSWER, CANCELLED -> "▲ " + row.words();
            case IDLE, FETCHING, NO_LOG -> row.words();
        };
    }

    private static SemanticColor color(LogRow row) {
        return switch (row.state()) {
            case HERE -> SemanticColor.OK;
            case FAILED, NO_ANSWER, CANCELLED -> SemanticColor.WARNING;
            case NO_LOG -> SemanticColor.MUTED;
            case IDLE, FETCHING -> SemanticColor.TEXT;
        };
    }

    private void look() {
        links.look();
        if (links.isRefused()) {
            look.stop();
        }
    }

    private void linksUnknown(String why) {
        if (!why.equals(noLinks)) {
            noLinks = why;
            refresh();
        }
    }

    /** The folder that is named; empty where the text cannot be one. */
    private Optional<Path> folder() {
        try {
            String text = folder.getText().strip();
            return text.isEmpty() ? Optional.empty() : Optional.of(Path.of(text));
        } catch (InvalidPathException unfit) {
            return Optional.empty();
        }
    }

    private Optional<String> whyNotBegin() {
        if (fetch.isRunning()) {
            return Optional.of("a fetch runs");
        }
        return fetch.rows().isEmpty() ? Optional.of(context.say("no boat is connected")) : Optional.empty();
    }

    private void begin() {
        Optional<Path> into = folder();
        if (into.isEmpty()) {
            folder.requestFocusInWindow();
            return;
        }
        List<LogRow> selected = table.allSelected();
        List<LogRow> chosen = selected.isEmpty() ? fetch.rows() : selected;
        fetch.begin(chosen.stream().map(LogRow::address).collect(Collectors.toSet()), into.get());
    }

    /** Shows the fetch as it is now. */
    void refresh() {
        table.show(fetch.rows());
        boolean bad = fetch.isBad() || !noLinks.isEmpty();
        String words = noLinks.isEmpty() ? fetch.said() : noLinks;
        said.setText((bad ? "▲ " : "") + context.say(words));
        said.setColor(bad ? SemanticColor.WARNING : SemanticColor.TEXT);
        said.setVisible(!words.isEmpty());
        begin.refresh();
        cancel.refresh();
        tableFit.fit(fetch.rows().size(), said.getText());
    }
}
