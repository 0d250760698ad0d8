package org.sami.crw.gui.mission;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import javax.swing.JComponent;
import javax.swing.JTable;
import javax.swing.TransferHandler;
import org.jspecify.annotations.Nullable;
import org.sami.crw.operator.mission.TaskMovePreview;
import org.sami.spn.value.TaskId;

/** Lets a task be dragged within the table of tasks; the change by a drop is shown while it is dragged. */
final class TaskTransfer extends TransferHandler {
    private final transient IntFunction<Optional<TaskId>> taskAt;
    private final transient BiFunction<TaskId, Integer, Optional<TaskMovePreview>> previewTo;
    private final transient Consumer<Optional<TaskMovePreview>> say;
    private final transient Consumer<TaskMovePreview> give;
    private transient Optional<TaskId> dragged = Optional.empty();

    /**
     * A handler of one table.
     *
     * @param taskAt the task of a row
     * @param previewTo what dropping a task on a row would change; empty where nothing
     * @param say receives what a drop would change now; empty when nothing is dragged any longer
     * @param give does it
     */
    TaskTransfer(
            IntFunction<Optional<TaskId>> taskAt,
            BiFunction<TaskId, Integer, Optional<TaskMovePreview>> previewTo,
            Consumer<Optional<TaskMovePreview>> say,
            Consumer<TaskMovePreview> give) {
        this.taskAt = taskAt;
        this.previewTo = previewTo;
        this.say = say;
        this.give = give;
    }

    @Override
    public int getSourceActions(JComponent component) {
        return MOVE;
    }

    @Override
    protected @Nullable Transferable createTransferable(JComponent component) {
        dragged = taskAt.apply(((JTable) component).getSelectedRow());
        return dragged.map(task -> new StringSelection(task.name())).orElse(null);
    }

    @Override
    public boolean canImport(TransferSupport support) {
        Optional<TaskMovePreview> preview = preview(support);
        say.accept(preview);
        return preview.isPresent();
    }

    /** Only what is dragged from this table itself is taken. */
    private Optional<TaskMovePreview> preview(TransferSupport support) {
        return support.isDrop()
                        && support.isDataFlavorSupported(DataFlavor.stringFlavor)
                        && support.getDropLocation() instanceof JTable.DropLocation place
                ? dragged.flatMap(task -> previewTo.apply(task, place.getRow()))
                : Optional.empty();
    }

    @Override
    public boolean importData(TransferSupport support) {
        Optional<TaskMovePreview> preview = preview(support);
        preview.ifPresent(give);
        return preview.isPresent();
    }

    @Override
    protected void exportDone(JComponent source, Transferable data, int action) {
        dragged = Optional.empty();
        say.accept(Optional.empty());
    }
}
