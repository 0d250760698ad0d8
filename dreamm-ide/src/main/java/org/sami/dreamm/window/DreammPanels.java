package org.sami.dreamm.window;

import java.awt.Dimension;
import java.util.List;
import org.sami.dreamm.canvas.ModelView;
import org.sami.dreamm.compare.ComparisonPanel;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.inspector.InspectorPanel;
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
    private static final Arrangement ROOMY = Arrangement.of("model-view")
            .right("palette", "model-view", 0.26)
            .left("mission-tree", "model-view", 0.24)
            .below("inspector", "palette", 0.55)
            .below("issues", "model-view", 0.36)
            .behind("try-out", "issues")
            .behind("replay", "issues")
            .behind("comparison", "model-view");

    /** Two columns instead of three: names are read, and the net keeps its room. */
    private static final Arrangement COMPACT = Arrangement.of("model-view")
            .right("mission-tree", "model-view", 0.38)
            .behind("palette", "mission-tree")
            .below("inspector", "mission-tree", 0.5)
            .below("issues", "model-view", 0.44)
            .behind("try-out", "issues")
            .behind("replay", "issues")
            .behind("comparison", "model-view");

    /** The net beside one stack of all that is done with it: each panel has half of the window. */
    private static final Arrangement TIGHT = Arrangement.of("model-view")
            .right("inspector", "model-view", 0.5)
            .behind("comparison", "model-view")
            .behind("mission-tree", "inspector")
            .behind("palette", "inspector")
            .behind("issues", "inspector")
            .behind("try-out", "inspector")
            .behind("replay", "inspector");

    /** How they lie at first: in three columns as in the thesis; in two in small windows or with large letters, and in two stacks in the smallest. */
    static final Arrangements FIRST =
            new Arrangements(ROOMY, COMPACT, TIGHT, new Dimension(1390, 0), new Dimension(720, 420));

    private final List<DockPanel> all;
    private final List<String> profileIds;

    DreammPanels(DreammContext context, RunParts run) {
        ModelView net = new ModelView(context);
        net.setAppendChoices(new PaletteSteps(context));
        PatternCommands.addTo(context);
        List<DockPanel> every = List.of(
                new DockPanel("mission-tree", "Mission tree", "layers", new MissionTreePanel(context)),
                new DockPanel("model-view", "Model view", "net", net)
                        .withFocusOn(net.net().canvas()),
                new DockPanel("palette", "Palette", "plus", new PalettePanel(context)),
                new DockPanel("inspector", "Inspector", "edit", new InspectorPanel(context, run.live())),
                new DockPanel("issues", "Issues", "alarm", run.issues()),
                new DockPanel("try-out", "Try it", "play", run.tryOut()),
                new DockPanel("replay", "Journal", "clock", run.replay()),
                new DockPanel("comparison", "Comparison", "compare", new ComparisonPanel(context)));
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

    /** All of them, in order. */
    List<DockPanel> all() {
        return all;
    }
}
