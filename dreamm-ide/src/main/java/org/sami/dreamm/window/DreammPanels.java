package org.sami.dreamm.window;

import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.dreamm.canvas.ModelView;
import org.sami.dreamm.compare.ComparisonPanel;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.inspector.InspectorPanel;
import org.sami.dreamm.learn.view.LearnPanel;
import org.sami.dreamm.palette.PalettePanel;
import org.sami.dreamm.palette.PaletteSteps;
import org.sami.dreamm.pattern.PatternCommands;
import org.sami.dreamm.profile.ProfileGuard;
import org.sami.dreamm.tree.MissionTreePanel;
import org.sami.ui.dock.Arrangement;
import org.sami.ui.dock.Arrangements;
import org.sami.ui.dock.DockPanel;

/** The panels of the window, and how they lie at first (thesis, Figure 5.1). Those that the profile hides are left out. */
final class DreammPanels {
    private static final String LEARN = "learn";

    /** The net with the drawing tools next to it; panels that check and run it open below it. */
    private static final Arrangement ROOMY = Arrangement.of("model-view")
            .right("palette", "model-view", 0.263)
            .behind("mission-tree", "palette")
            .below("inspector", "palette", 0.55)
            .below("issues", "model-view", 0.36)
            .behind("try-out", "issues")
            .behind("replay", "issues")
            .behind("queries", "issues")
            .behind("comparison", "model-view")
            .folding("issues", "try-out", "replay", "queries", "comparison");

    /** The net alone; panels open in one stack next to it. */
    private static final Arrangement COMPACT = nextToOneStack(0.42);

    /** The same with more than half of the window for what is opened. */
    private static final Arrangement TIGHT = nextToOneStack(0.54);

    /** How they lie at first: the net has most of the window, in small windows and with large letters all of it (docs/windows.md). */
    static final Arrangements FIRST =
            new Arrangements(ROOMY, COMPACT, TIGHT, new Dimension(1200, 0), new Dimension(720, 420));

    /** The same for a window of the course, whose panel has the left side. */
    static final Arrangements OF_COURSE = new Arrangements(
            Arrangement.of("model-view")
                    .left(LEARN, "model-view", 0.4)
                    .right("palette", "model-view", 0.3)
                    .behind("mission-tree", "palette")
                    .below("inspector", "palette", 0.5)
                    .below("issues", "model-view", 0.36)
                    .behind("try-out", "issues")
                    .behind("replay", "issues")
                    .behind("queries", "issues")
                    .behind("comparison", "model-view")
                    .folding("issues", "try-out", "replay", "queries", "comparison"),
            nextToCourse(0.42),
            nextToCourse(0.5),
            new Dimension(1400, 0),
            new Dimension(900, 420));

    private static Arrangement nextToCourse(double part) {
        return Arrangement.of("model-view")
                .left(LEARN, "model-view", part)
                .below("inspector", "model-view", 0.5)
                .behind("comparison", "model-view")
                .behind("mission-tree", "inspector")
                .behind("palette", "inspector")
                .behind("issues", "inspector")
                .behind("try-out", "inspector")
                .behind("replay", "inspector")
                .behind("queries", "inspector")
                .folding(
                        "inspector", "mission-tree", "palette", "issues", "try-out", "replay", "queries", "comparison");
    }

    private static Arrangement nextToOneStack(double part) {
        return Arrangement.of("model-view")
                .right("inspector", "model-view", part)
                .behind("comparison", "model-view")
                .behind("mission-tree", "inspector")
                .behind("palette", "inspector")
                .behind("issues", "inspector")
                .behind("try-out", "inspector")
                .behind("replay", "inspector")
                .behind("queries", "inspector")
                .folding(
                        "inspector", "mission-tree", "palette", "issues", "try-out", "replay", "queries", "comparison");
    }

    private final List<DockPanel> all;
    private final List<String> profileIds;
    private final ComparisonPanel comparison;

    DreammPanels(DreammContext context, RunParts run) {
        this(context, run, Optional.empty());
    }

    /**
     * The panels of a window.
     *
     * @param learn the panel of the course, in a window of it
     */
    DreammPanels(DreammContext context, RunParts run, Optional<LearnPanel> learn) {
        ModelView net = new ModelView(context);
        net.setAppendChoices(new PaletteSteps(context));
        PatternCommands.addTo(context);
        comparison = new ComparisonPanel(context);
        List<DockPanel> every = new ArrayList<>(List.of(
                new DockPanel("mission-tree", "Mission tree", "layers", new MissionTreePanel(context)),
                new DockPanel("model-view", "Model view", "net", net)
                        .withFocusOn(net.net().canvas()),
                new DockPanel("palette", "Palette", "plus", new PalettePanel(context)),
                new DockPanel("inspector", "Inspector", "edit", new InspectorPanel(context, run.live())),
                new DockPanel("issues", "Issues", "alarm", run.issues()),
                new DockPanel("try-out", "Try it", "play", run.tryOut()),
                new DockPanel("replay", "Journal", "clock", run.replay()),
                new DockPanel("comparison", "Comparison", "compare", comparison)));
        learn.ifPresent(
                content -> every.add(new DockPanel(LEARN, "Learn", "help", content).withFocusOn(content.first())));
        every.add(new DockPanel("queries", "Queries", "search", run.queries()));
        profileIds = every.stream().map(DreammPanels::profileId).toList();
        all = every.stream()
                .filter(panel -> context.profile().shows(profileId(panel)))
                .toList();
        ProfileGuard guard = new ProfileGuard(context.profile());
        all.forEach(guard::guard);
    }

    private static String profileId(DockPanel panel) {
        return "panel-" + panel.getPersistentID();
    }

    /** The ids by which profiles name them, of those that are hidden as well. */
    List<String> profileIds() {
        return profileIds;
    }

    /** The one that compares the open plan with another. */
    ComparisonPanel comparison() {
        return comparison;
    }

    /** All of them, in order. */
    List<DockPanel> all() {
        return all;
    }
}
