package org.sami.dreamm.window;

import java.util.LinkedHashSet;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.palette.PalettePanel;
import org.sami.dreamm.profile.ProfileIds;

/** The ids by which profiles name what a window has, once all of its commands are there. */
final class WindowIds {
    private final DreammContext context;
    private final DreammPanels panels;

    WindowIds(DreammContext context, DreammPanels panels) {
        this.context = Objects.requireNonNull(context, "context");
        this.panels = Objects.requireNonNull(panels, "panels");
    }

    /** All of them, of what is hidden as well. */
    Set<String> all() {
        Set<String> ids = new LinkedHashSet<>(context.commands().ids());
        ids.addAll(panels.profileIds());
        ids.addAll(PalettePanel.profileIds(context));
        ids.addAll(ProfileIds.fixed());
        return ids;
    }

    /** What the profile names that the window does not have, in one sentence; empty where it has all. */
    Optional<String> unknown() {
        return ProfileIds.unknown(context.profile(), all());
    }
}
