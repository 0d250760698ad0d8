package org.sami.dreamm.file;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.sami.ui.window.WindowSettings;

/** The projects that were opened or saved last, the newest first, kept in the window's settings. On the event thread. */
public final class RecentProjects {
    private static final int MOST = 8;
    private static final String KEY = "recent.";

    private final WindowSettings settings;

    /** The projects of a window's settings. */
    public RecentProjects(WindowSettings settings) {
        this.settings = settings;
    }

    /** Files and folders, the newest first. */
    public List<Path> all() {
        List<Path> all = new ArrayList<>();
        for (int i = 0; i < MOST; i++) {
            String text = settings.text(KEY + i);
            if (!text.isEmpty()) {
                all.add(Path.of(text));
            }
        }
        return all;
    }

    /** A project was opened or saved. */
    public void add(Path project) {
        List<Path> next = new ArrayList<>(all());
        next.remove(project);
        next.add(0, project);
        for (int i = 0; i < Math.min(MOST, next.size()); i++) {
            settings.keep(KEY + i, next.get(i).toString());
        }
    }
}
