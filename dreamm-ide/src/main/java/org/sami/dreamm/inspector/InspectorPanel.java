package org.sami.dreamm.inspector;

import java.awt.Point;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.EditorListener;
import org.sami.dreamm.issues.LiveFindings;
import org.sami.dreamm.palette.PaletteItem;
import org.sami.dreamm.palette.PaletteList;
import org.sami.palette.SemanticColor;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.wizard.EventTarget;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.ScrolledPanel;
import org.sami.ui.look.Spacing;

/** Editors of what is selected, one below the other; of the plan where nothing is selected. The focus stays where it is over an edit. */
public final class InspectorPanel extends JPanel {
    /** Two lines of a finding and the button of its fix. */
    private static final int STRIP = 64;

    private final transient DreammContext context;
    private final JLabel title = new JLabel();
    private final ScrolledPanel column =
            new ScrolledPanel(new MigLayout("novisualpadding, insets 0, gap 0 8, wrap 1, fillx", "[grow, fill]"));
    private final JScrollPane scrolled = column.inPane();
    private final ScrolledPanel found =
            new ScrolledPanel(new MigLayout("novisualpadding, insets 4 0 0 0, wrap 1, fillx", "[grow, fill]"));
    private final JScrollPane strip = found.inPane();
    private final transient LiveFindings live;
    private transient List<Finding> shownFindings = List.of();
    private transient Optional<String> shownPlan = Optional.empty();
    private transient Set<String> shownSelection = Set.of();
    private transient Map<String, String> shownBounds = Map.of();
    private boolean giving;

    /**
     * The inspector of a window.
     *
     * @param live the findings about the document, which all panels share
     */
    public InspectorPanel(DreammContext context, LiveFindings live) {
        super(new MigLayout(
                "novisualpadding, insets " + Spacing.NORMAL + ", gap 0 4, wrap 1, fill",
                "[grow, fill]",
                "[][grow, fill][]"));
        this.context = context;
        this.live = live;
        setName("inspector-panel");
        LookColors.background(this, SemanticColor.SURFACE);
        title.setName("inspector-title");
        found.setOpaque(false);
        add(title, "wmin 0");
        add(scrolled, "wmin 0, hmin 0");
        strip.setName("inspector-strip");
        LookColors.border(strip, () -> BorderFactory.createMatteBorder(1, 0, 0, 0, SemanticColor.BORDER.get()));
        add(
                strip,
                "wmin 0, h " + STRIP
                        + "!, hidemode 3"); // as high with findings as without, so that nothing moves as they come
        context.document().addListener(change -> rebuild());
        context.typed().add(this::takeWhatIsTyped);
        live.addListener(this::findingsChanged);
        context.editor().addListener(new EditorListener() {
            @Override
            public void planOpened() {
                rebuild();
            }

            @Override
            public void selectionChanged() {
                giveWhatIsTyped();
                rebuild();
            }
        });
        context.overlay().addListener(() -> {
            Map<String, String> bounds = context.overlay().shown().badges().bounds();
            if (!bounds.equals(shownBounds)) {
                shownBounds = bounds;
                rebuild();
            }
        });
        rebuild();
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (title != null) {
            title.setFont(Fonts.heading());
        }
    }

    /** Another vertex was selected before the field was left: what stands in it is taken first. */
    private void giveWhatIsTyped() {
        giving = true;
        try {
            Pending.give(column);
        } finally {
            giving = false;
        }
    }

    /** The project is about to be saved or left: what stands in the fields is of it. */
    private void takeWhatIsTyped() {
        Project before = context.document().project();
        giveWhatIsTyped();
        if (!before.equals(context.document().project())) {
            rebuild();
        }
    }

    /** Shows what is selected now. Of the same selection, what the author works at stays where it is. */
    private void rebuild() {
        if (giving) {
            return;
        }
        Optional<String> plan = context.editor().planId();
        Set<String> selection = Set.copyOf(context.editor().selection());
        boolean same = plan.equals(shownPlan) && selection.equals(shownSelection);
        shownPlan = plan;
        shownSelection = selection;
        ScrollAnchor anchor = ScrollAnchor.of(scrolled);
        column.removeAll();
        context.editor().plan().ifPresentOrElse(this::fill, () -> title.setText("No plan is open"));
        column.revalidate();
        column.repaint();
        if (same) {
            anchor.restore();
        } else {
            scrolled.getViewport().setViewPosition(new Point());
        }
    }

    private void fill(Plan plan) {
        title.setFont(Fonts.heading());
        Selected selected = Selected.of(plan, context.editor().selection());
        if (selected.isEmpty()) {
            title.setText("Plan " + plan.title());
            title.setToolTipText(title.getText());
            column.add(new PlanSection(context, plan));
            strip.setVisible(false);
            return;
        }
        strip.setVisible(selected.vertices() + selected.edges() > 0);
        title.setText(selected.title(plan, context.vocabulary()));
        title.setToolTipText(selected.title(plan, context.vocabulary()));
        showFindings();
        if (selected.vertices() + selected.edges() == 0) {
            column.add(new FrameSection(context, plan, selected.frames()));
        }
        if (selected.vertices() > 0) {
            column.add(new VertexSection(context, plan, selected));
        }
        if (selected.edges() > 0) {
            column.add(lock(plan, selected));
        }
        if (selected.vertices() == 1 && selected.edges() == 0) {
            selected.places().forEach(p -> place(plan, p));
            selected.transitions().forEach(t -> transition(plan, t));
        }
        if (selected.vertices() == 0 && selected.edges() == 1) {
            selected.inEdges().forEach(e -> column.add(new InRequirementRows(context, plan, e)));
            selected.outEdges().forEach(e -> column.add(new OutRequirementRows(context, plan, e)));
        }
    }

    /** Findings come a moment after the edit that they are about, into a strip of their own: nothing else moves. */
    private void findingsChanged() {
        if (!selectedFindings().equals(shownFindings)) {
            showFindings();
        }
    }

    private void showFindings() {
        shownFindings = selectedFindings();
        found.removeAll();
        found.add(new FindingRows(context, shownFindings), "wmin 0");
        found.revalidate();
        found.repaint();
    }

    private List<Finding> selectedFindings() {
        return context.editor()
                .plan()
                .map(plan -> Selected.of(plan, context.editor().selection()).findings(plan, live.findings()))
                .orElse(List.of());
    }

    private JComponent lock(Plan plan, Selected selected) {
        boolean locked = selected.inEdges().stream().allMatch(e -> e.locked())
                && selected.outEdges().stream().allMatch(e -> e.locked());
        Form form = new Form();
        form.flag(
                "Locked",
                "inspector-locked",
                "Whether additions and deletions leave the requirements as they are (thesis 5.1.1); edges of manual"
                        + " sequences are",
                locked,
                on -> context.apply(new EdgeEdit.SetLocked(plan.id(), selected.edgeIds(), on)));
        return form;
    }

    private void place(Plan plan, Place place) {
        Scope scope = Scope.of(context, plan);
        for (int i = 0; i < place.outputs().size(); i++) {
            column.add(new EventCard(context, scope, place.outputs().get(i), i));
        }
        for (int i = 0; i < place.subMissions().size(); i++) {
            column.add(new SubMissionCard(context, plan, place.subMissions().get(i), i));
        }
        events(place.id(), Direction.OUTPUT);
    }

    private void transition(Plan plan, Transition transition) {
        Scope scope = Scope.of(context, plan);
        for (int i = 0; i < transition.inputs().size(); i++) {
            column.add(new EventCard(context, scope, transition.inputs().get(i), i));
        }
        events(transition.id(), Direction.INPUT);
    }

    /** The events that can be added here (thesis, Figure 5.3). */
    private void events(String vertex, Direction direction) {
        Form form = new Form();
        form.setName("inspector-add-event");
        form.heading("Add an event");
        form.wide(new PaletteList(
                context,
                "inspector-events",
                item -> item instanceof PaletteItem.Event event && event.type().direction() == direction,
                item -> context.additions()
                        .add(context.additions()
                                .event(((PaletteItem.Event) item).type().name(), new EventTarget.OnVertex(vertex)))));
        column.add(form, "hmin 160");
    }
}
