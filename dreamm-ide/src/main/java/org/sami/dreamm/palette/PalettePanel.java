package org.sami.dreamm.palette;

import java.awt.BorderLayout;
import java.awt.GraphicsEnvironment;
import java.util.Optional;
import java.util.Set;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.EditorListener;
import org.sami.dreamm.wizard.SequenceStrip;
import org.sami.palette.SemanticColor;
import org.sami.spn.edit.Edit;
import org.sami.ui.command.Command;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.ScrolledPanel;
import org.sami.ui.look.Spacing;

/** The toolset palette: the list of what can be added, and below it what the marked item is and what would come with it. */
public final class PalettePanel extends JPanel {
    private final transient DreammContext context;
    private final transient PaletteEdits edits;
    private final PaletteList list;
    private final SequenceStrip strip;

    /** The palette of a window. */
    public PalettePanel(DreammContext context) {
        super(new MigLayout(
                "insets " + Spacing.NORMAL + ", gap 0 8, wrap 1, fill",
                "[grow, fill]",
                "[72:pref:, grow, fill, shrinkprio 200][24:pref:, shrinkprio 50]"));
        this.context = context;
        this.edits = new PaletteEdits(context);
        this.list = new PaletteList(context, "palette", item -> true, this::add);
        this.strip = new SequenceStrip(context.additions());
        setName("palette-panel");
        LookColors.background(this, SemanticColor.SURFACE);
        add(list, "wmin 0, hmin 72");
        ScrolledPanel below = new ScrolledPanel(new BorderLayout());
        below.add(strip);
        add(below.inPane(), "wmin 0, hmin 0");
        if (!GraphicsEnvironment.isHeadless()) {
            list.enableDrag();
        }
        list.whenSelected(this::refresh);
        strip.whenConfirmed(() -> list.selected().ifPresent(this::add));
        context.additions().addListener(() -> {
            list.fill();
            refresh();
        });
        context.editor().addListener(new EditorListener() {
            @Override
            public void planOpened() {
                refresh();
            }

            @Override
            public void selectionChanged() {
                refresh();
            }
        });
        context.commands()
                .add(new Command("palette-find", "Find what to add", () -> {
                            context.commands()
                                    .find("panel-palette")
                                    .ifPresent(Command::run); // it may be behind another
                            list.searchField().requestFocusInWindow();
                            list.searchField().selectAll();
                        })
                        .withKey("ctrl SPACE")
                        .withIcon("plus"));
        refresh();
    }

    /** The ids by which profiles name what the palette offers. */
    public static Set<String> profileIds(DreammContext context) {
        return new PaletteGroups(context, item -> true).profileIds();
    }

    private void add(PaletteItem item) {
        edits.refusal(item, edits.target(item))
                .ifPresentOrElse(
                        context.notices()::refused,
                        () -> context.additions().add(strip.chosen(edits.edit(item, edits.target(item)))));
    }

    private void refresh() {
        Optional<PaletteItem> item = list.selected();
        Optional<Edit> edit =
                item.filter(i -> edits.refusal(i, edits.target(i)).isEmpty()).map(i -> edits.edit(i, edits.target(i)));
        strip.show(
                item.map(PaletteItem::label).orElse(""),
                item.map(PaletteItem::help).orElse(""),
                edit,
                item.flatMap(i -> edits.refusal(i, edits.target(i))));
        revalidate(); // the strip has another height, and its scroll pane keeps that to itself
    }
}
