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
import org.sami.crw.operator.mission.TaskGift;
import org.sami.spn.value.TaskId;

/** Lets a task be dragged within the table of tasks; what a drop would change is said while it is dragged. */
final class TaskTransfer extends TransferHandler {
    private final transient IntFunction<Optional<TaskId>> taskAt;
    private final transient BiFunction<TaskId, Integer, Optional<TaskGift>> giftTo;
    private final transient Consumer<Optional<TaskGift>> say;
    private final transient Consumer<TaskGift> give;
    private transient Optional<TaskId> dragged = Optional.empty();

    /**
     * A handler of one table.
     *
     * @param taskAt the task of a row
     * @param giftTo what dropping a task on a row would change; empty where nothing
     * @param say is told what a drop would change now; empty when nothing is dragged any longer
     * @param give does it
     */
    TaskTransfer(
            IntFunction<Optional<TaskId>> taskAt,
            BiFunction<TaskId, Integer, Optional<TaskGift>> giftTo,
            Consumer<Optional<TaskGift>> say,
            Consumer<TaskGift> give) {
        this.taskAt = taskAt;
        this.giftTo = giftTo;
        this.say = say;
        this.give = give;
    }

    @Override
    public int getSourceActions(JComponent component) {
        return MOVE;
    }

    @Override
    protected Transferable createTransferable(JComponent component) {
        dragged = taskAt.apply(((JTable) component).getSelectedRow());
        return dragged.map(task -> new StringSelection(task.name())).orElse(null);
    }

    @Override
    public boolean canImport(TransferSupport support) {
        Optional<TaskGift> gift = gift(support);
        say.accept(gift);
        return gift.isPresent();
    }

    /** Only what is dragged from this table itself is taken. */
    private Optional<TaskGift> gift(TransferSupport support) {
        return support.isDrop()
                        && support.isDataFlavorSupported(DataFlavor.stringFlavor)
                        && support.getDropLocation() instanceof JTable.DropLocation place
                ? dragged.flatMap(task -> giftTo.apply(task, place.getRow()))
                : Optional.empty();
    }

    @Override
    public boolean importData(TransferSupport support) {
        Optional<TaskGift> gift = gift(support);
        gift.ifPresent(give);
        return gift.isPresent();
    }

    @Override
    protected void exportDone(JComponent source, Transferable data, int action) {
        dragged = Optional.empty();
        say.accept(Optional.empty());
    }
}
