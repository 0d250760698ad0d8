package org.sami.crw.gui.mission;

import java.awt.BorderLayout;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import javax.swing.DropMode;
import javax.swing.Icon;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.mission.AllocationSnapshot;
import org.sami.crw.operator.mission.TaskMovePreview;
import org.sami.palette.SemanticColor;
import org.sami.spn.value.NaturalOrder;
import org.sami.spn.value.TaskId;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.FoldingPanel;
import org.sami.ui.look.MarkIcon;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;
import org.sami.ui.value.WrappedText;

/**
 * Who has which tasks, in the order in which they are done, and which nobody has. A task is dragged to a row of another boat, or given by a
 * menu; what that changes stands below while it is dragged, and in the menu.
 */
public final class AllocationPanel extends FoldingPanel {
    private static final int LOW = 200;
    private static final String HINT = "Drag a task to another boat, or give it by the button.";

    private final OperatorContext context;
    private final RowTable<Row> table;
    private final WrappedText effect = new WrappedText("");
    private final JPanel tools = new JPanel(
            new MigLayout("novisualpadding, hidemode 3, insets 4 8 4 8, gap 8, fillx", "[grow,fill][]", "[center]"));
    private final Command give;
    private final CommandButton giveButton;
    private final CommandButton beside;
    private final transient Fold low = foldBelowHeight(LOW, this::foldTools);
    private List<Row> rows = List.of();

    /** A task and whose it is (empty text where nobody has it), or a boat without a task. */
    private record Row(String boat, int place, Optional<TaskId> task) {}

    /** The tasks of the session. */
    public AllocationPanel(OperatorContext context) {
        super(new BorderLayout());
        this.context = context;
        table = new RowTable<>(
                "allocation-table",
                context.say("No task. Plans of tasks divide them here among the boats, each with its own queue."),
                row -> row.task().<Object>map(task -> task).orElse(row.boat()),
                List.of(
                        RowColumn.<Row>words(
                                        context.say("Boat"),
                                        96,
                                        row -> row.boat().isEmpty() ? "nobody" : row.boat())
                                .withIcon(this::mark),
                        RowColumn.number("Turn", 56, row -> row.place() == 0 ? "–" : row.place() + "."),
                        RowColumn.<Row>words("Task", 0, this::words)
                                .colored(row -> row.task().isPresent() ? SemanticColor.TEXT : SemanticColor.MUTED)));
        give = context.commands()
                .add(new Command("allocation-give", "Give the task to…", this::openMenu)
                        .withKey("ctrl K")
                        .withIcon("allocation")
                        .unless(() -> chosen().isPresent()
                                ? Optional.empty()
                                : Optional.of("select a task in the table of tasks first")));
        giveButton = new CommandButton(give);
        beside = CommandButton.iconOnly(give);
        table.addSelectionListener(give::refresh);
        JTable view = table.table();
        view.getInputMap().put(KeyStroke.getKeyStroke("ENTER"), "give");
        view.getActionMap().put("give", give);
        view.setSelectionMode(ListSelectionModel.SINGLE_SELECTION); // else a drag from a row selects more rows
        view.setDropMode(DropMode.ON);
        view.setTransferHandler(new TaskTransfer(this::taskAt, this::previewTo, this::say, this::give));
        view.setDragEnabled(context.whyNotAct().isEmpty() && !GraphicsEnvironment.isHeadless());
        effect.setName("allocation-effect");
        effect.setColor(SemanticColor.MUTED);
        tools.add(effect, "wmin 60");
        tools.add(giveButton);
        beside.setName("allocation-give-icon");
        beside.setVisible(false);
        add(table);
        add(tools, BorderLayout.SOUTH);
        JPanel edge = new JPanel(new MigLayout("novisualpadding, insets 2, hidemode 3"));
        edge.add(beside);
        add(edge, BorderLayout.EAST);
        context.models().allocation().addListener(this::show);
        show(context.models().allocation().snapshot());
    }

    /**
     * A low panel has its button next to the table, and the strip shows what dropping a task would change: text below the table would move
     * rows under the pointer.
     */
    private void foldTools(boolean toEdge) {
        beside.setVisible(toEdge);
        giveButton.setVisible(!toEdge);
        tools.setVisible(!toEdge);
    }

    private String words(Row row) {
        return row.task()
                .map(task -> task.name() + " (" + context.titles().words(task.mission()) + ")")
                .orElse("no task");
    }

    private Optional<Icon> mark(Row row) {
        return row.boat().isEmpty()
                ? Optional.empty()
                : Optional.of(new MarkIcon(context.marks().of(row.boat())));
    }

    private void show(AllocationSnapshot now) {
        List<Row> next = new ArrayList<>();
        boolean any = !now.queues().values().stream().allMatch(List::isEmpty)
                || !now.unallocated().isEmpty();
        if (any) {
            boats().forEach(boat -> {
                List<TaskId> tasks = now.queues().getOrDefault(boat, List.of());
                for (int i = 0; i < tasks.size(); i++) {
                    next.add(new Row(boat, i + 1, Optional.of(tasks.get(i))));
                }
                if (tasks.isEmpty()) {
                    next.add(new Row(boat, 0, Optional.empty()));
                }
            });
            now.unallocated().forEach(task -> next.add(new Row("", 0, Optional.of(task))));
        }
        rows = next;
        table.show(next);
        give.refresh();
    }

    /** All boats that are known or have a task, by name. */
    private List<String> boats() {
        TreeSet<String> all = new TreeSet<>(NaturalOrder.INSTANCE);
        all.addAll(context.models().allocation().snapshot().queues().keySet());
        context.models().fleet().snapshot().stream().map(BoatSnapshot::boat).forEach(all::add);
        return List.copyOf(all);
    }

    private Optional<TaskId> chosen() {
        return table.selected().flatMap(Row::task);
    }

    private Optional<TaskId> taskAt(int row) {
        return row >= 0 && row < rows.size() ? rows.get(row).task() : Optional.empty();
    }

    /** What dropping a task on a row would change. */
    private Optional<TaskMovePreview> previewTo(TaskId task, int row) {
        return row >= 0 && row < rows.size() ? preview(task, rows.get(row).boat()) : Optional.empty();
    }

    private Optional<TaskMovePreview> preview(TaskId task, String boat) {
        return TaskMovePreview.of(
                task,
                Optional.of(boat).filter(name -> !name.isEmpty()),
                context.models().allocation().snapshot());
    }

    private void say(Optional<TaskMovePreview> preview) {
        effect.setText(preview.map(TaskMovePreview::words).orElse(context.say(HINT)));
        effect.setColor(preview.isPresent() ? SemanticColor.ACCENT : SemanticColor.MUTED);
        if (low.isFolded()) {
            preview.ifPresent(shown -> context.notices().show(shown.words()));
        }
    }

    private void give(TaskMovePreview preview) {
        say(Optional.empty());
        context.tell(context.session().moveTask(preview.task(), preview.to()), preview.words());
    }

    /** The menu of boats that can get the chosen task; each entry says what it changes. */
    JPopupMenu menu() {
        JPopupMenu menu = new JPopupMenu();
        menu.setName("allocation-menu");
        chosen().ifPresent(task -> {
            List<String> whom = new ArrayList<>(boats());
            whom.add("");
            whom.forEach(boat -> preview(task, boat).ifPresent(preview -> {
                JMenuItem item = new JMenuItem(preview.words());
                item.setName("allocation-give-" + (boat.isEmpty() ? "nobody" : boat));
                if (!boat.isEmpty()) {
                    item.setIcon(new MarkIcon(context.marks().of(boat)));
                }
                item.addActionListener(e -> give(preview));
                menu.add(item);
            }));
        });
        return menu;
    }

    private void openMenu() {
        JTable view = table.table();
        Rectangle row = view.getCellRect(Math.max(0, view.getSelectedRow()), 2, true);
        menu().show(view, row.x, row.y + row.height);
    }
}
