package org.sami.dreamm.palette;

import java.util.Objects;
import java.util.Optional;
import org.sami.dreamm.canvas.NetDrop;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.edit.Edit;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Plan;
import org.sami.spn.wizard.EventTarget;

/** An item of the palette that is dragged: says onto which vertex it can be let go, and which edit that is (thesis 5.1, Toolset Palette). */
final class PaletteDrop implements NetDrop {
    private final DreammContext context;
    private final PaletteItem item;
    private final PaletteEdits edits;

    PaletteDrop(DreammContext context, PaletteItem item) {
        this.context = Objects.requireNonNull(context, "context");
        this.item = Objects.requireNonNull(item, "item");
        this.edits = new PaletteEdits(context);
    }

    @Override
    public String label() {
        return item.label();
    }

    @Override
    public Optional<String> whyNotOnto(Plan plan, String vertex) {
        return edits.refusal(item, new EventTarget.OnVertex(vertex));
    }

    @Override
    public Edit onto(Plan plan, String vertex, Mode mode) {
        return context.additions().noted(edits.edit(item, new EventTarget.OnVertex(vertex)));
    }

    @Override
    public Optional<Edit> ontoEdge(Plan plan, String edge) {
        return item instanceof PaletteItem.Role role
                        && edits.refusal(item, new EventTarget.Free(Optional.empty()))
                                .isEmpty()
                ? RoleOnEdge.of(plan, role.taskClass().name(), edge)
                : Optional.empty();
    }

    @Override
    public Edit at(Plan plan, LayoutPoint at, Mode mode) {
        return context.additions().noted(edits.edit(item, new EventTarget.Free(Optional.of(at))));
    }
}
