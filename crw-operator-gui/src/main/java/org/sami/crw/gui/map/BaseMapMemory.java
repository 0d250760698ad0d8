package org.sami.crw.gui.map;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.sami.ui.map.BaseMapState;
import org.sami.ui.map.MapListener;
import org.sami.ui.map.MapView;
import org.sami.ui.window.WindowSettings;

/** Keeps in a window's settings which base maps its map has and which of them are on, for the next window. */
final class BaseMapMemory {
    private static final String KEY = "base-maps";
    private static final String ON = "on ";
    private static final String OFF = "off ";
    private static final int MOST = 12; // the newest ones

    private final WindowSettings settings;
    private final MapView view;

    private BaseMapMemory(WindowSettings settings, MapView view) {
        this.settings = settings;
        this.view = view;
    }

    /** Gives a map the base maps of an earlier window, and keeps from now on those that it has. */
    static void of(MapView view, WindowSettings settings) {
        BaseMapMemory memory = new BaseMapMemory(settings, view);
        memory.restore();
        view.addMapListener(new MapListener() {
            @Override
            public void baseMapsChanged() {
                memory.keep();
            }
        });
    }

    private void restore() {
        settings.text(KEY).lines().forEach(line -> {
            boolean on = line.startsWith(ON);
            if (on || line.startsWith(OFF)) {
                try {
                    view.restoreBaseMap(Path.of(line.substring((on ? ON : OFF).length())), on);
                } catch (InvalidPathException edited) {
                    // the settings were written by hand, and this is no file
                }
            }
        });
    }

    private void keep() {
        List<BaseMapState> all = view.baseMaps();
        String now = all.subList(Math.max(0, all.size() - MOST), all.size()).stream()
                .map(map -> (map.on() ? ON : OFF) + map.file().toAbsolutePath())
                .collect(Collectors.joining("\n"));
        if (!now.equals(settings.text(KEY))) {
            settings.keep(KEY, now);
        }
    }
}
