package org.sami.dreamm.palette;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.IOException;
import java.util.Objects;
import java.util.Optional;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.wizard.EventTarget;

/** What is dragged from the palette: says where it may be let go, and adds itself there. On the event thread. */
public final class PaletteDrop {
    private static final DataFlavor FLAVOR = flavor();

    private final DreammContext context;
    private final PaletteItem item;
    private final PaletteEdits edits;

    PaletteDrop(DreammContext context, PaletteItem item) {
        this.context = Objects.requireNonNull(context, "context");
        this.item = Objects.requireNonNull(item, "item");
        this.edits = new PaletteEdits(context);
    }

    private static DataFlavor flavor() {
        try {
            return new DataFlavor(
                    DataFlavor.javaJVMLocalObjectMimeType + ";class=\"" + PaletteDrop.class.getName() + "\"",
                    "SAMI palette item",
                    PaletteDrop.class.getClassLoader());
        } catch (ClassNotFoundException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Whether something that is dragged comes from a palette. */
    public static boolean isIn(Transferable transferable) {
        return transferable.isDataFlavorSupported(FLAVOR);
    }

    /** What is dragged, where it comes from a palette of this program. */
    public static Optional<PaletteDrop> of(Transferable transferable) {
        try {
            return isIn(transferable)
                    ? Optional.of((PaletteDrop) transferable.getTransferData(FLAVOR))
                    : Optional.empty();
        } catch (UnsupportedFlavorException | IOException e) {
            return Optional.empty();
        }
    }

    /** What people call it. */
    public String label() {
        return item.label();
    }

    /**
     * Why it cannot be let go here, in one sentence; empty where it can.
     *
     * @param vertex id of the vertex under the pointer; empty over free space
     */
    public Optional<String> refusal(Optional<String> vertex) {
        return edits.refusal(item, target(vertex, new LayoutPoint(0, 0)));
    }

    /**
     * Adds it: to the vertex under the pointer, or as a vertex of its own (thesis 5.1, Toolset Palette). Why it cannot be is told in the status
     * line.
     *
     * @param vertex id of the vertex under the pointer; empty over free space
     * @param at the point under the pointer, in drawing units
     */
    public void drop(Optional<String> vertex, LayoutPoint at) {
        EventTarget target = target(vertex, at);
        edits.refusal(item, target)
                .ifPresentOrElse(
                        context.notices()::refused, () -> context.additions().add(edits.edit(item, target)));
    }

    private static EventTarget target(Optional<String> vertex, LayoutPoint at) {
        return vertex.isPresent() ? new EventTarget.OnVertex(vertex.get()) : new EventTarget.Free(Optional.of(at));
    }

    Transferable transferable() {
        PaletteDrop self = this;
        return new Transferable() {
            @Override
            public DataFlavor[] getTransferDataFlavors() {
                return new DataFlavor[] {FLAVOR};
            }

            @Override
            public boolean isDataFlavorSupported(DataFlavor flavor) {
                return FLAVOR.equals(flavor);
            }

            @Override
            public Object getTransferData(DataFlavor flavor) throws UnsupportedFlavorException {
                if (!isDataFlavorSupported(flavor)) {
                    throw new UnsupportedFlavorException(flavor);
                }
                return self;
            }
        };
    }
}
