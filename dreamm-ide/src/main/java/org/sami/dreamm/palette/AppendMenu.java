package org.sami.dreamm.palette;

import java.util.List;
import java.util.Optional;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.model.Plan;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.wizard.EventTarget;
import org.sami.spn.wizard.NextEvents;

/** What can come next at a vertex, as a menu: choosing one draws it behind the vertex. On the event thread. */
public final class AppendMenu {
    private final DreammContext context;
    private final PaletteEdits edits;

    /** Menus for the vertices of the open plan. */
    public AppendMenu(DreammContext context) {
        this.context = context;
        this.edits = new PaletteEdits(context);
    }

    /** The menu of a vertex: what its events can cause or usually bring, then blank vertices, then every event by group. */
    public JPopupMenu at(String vertex) {
        JPopupMenu menu = new JPopupMenu("What can come next");
        menu.setName("append-menu");
        Optional<Plan> plan = context.editor().plan();
        if (plan.isEmpty()) {
            return menu;
        }
        EventTarget behind = new EventTarget.Behind(vertex);
        List<NextEvents.Next> next =
                new NextEvents(context.vocabulary(), context.additions().library()).at(plan.get(), vertex);
        for (NextEvents.Next one : next) {
            JMenuItem item = item(new PaletteItem.Event(one.event()), behind);
            item.setToolTipText(
                    one.event().label() + " " + one.cause() + ". " + one.event().help());
            if (one.drawn()) {
                item.setText(item.getText() + "   (drawn already)");
            }
            menu.add(item);
        }
        if (!next.isEmpty()) {
            menu.addSeparator();
        }
        boolean place = plan.get().place(vertex).isPresent();
        menu.add(item(place ? new PaletteItem.BlankTransition() : new PaletteItem.BlankPlace(), behind));
        Direction direction = place ? Direction.INPUT : Direction.OUTPUT;
        PaletteGroups groups = new PaletteGroups(
                context,
                i -> i instanceof PaletteItem.SubMission
                        || (i instanceof PaletteItem.Event event && event.type().direction() == direction));
        for (PaletteGroup group : groups.matching("")) {
            JMenu more = new JMenu(group.name());
            more.setName("append-" + group.id());
            group.items().forEach(i -> more.add(item(i, behind)));
            menu.add(more);
        }
        return menu;
    }

    private JMenuItem item(PaletteItem item, EventTarget behind) {
        JMenuItem entry = new JMenuItem(item.mark() + "  " + item.label());
        entry.setName("append-" + item.id());
        entry.setToolTipText(item.help());
        Optional<String> refusal = edits.refusal(item, behind);
        entry.setEnabled(refusal.isEmpty());
        refusal.ifPresent(entry::setToolTipText);
        entry.addActionListener(e -> context.additions().add(edits.edit(item, behind)));
        return entry;
    }
}
