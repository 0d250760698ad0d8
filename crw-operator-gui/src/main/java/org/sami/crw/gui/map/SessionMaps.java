package org.sami.crw.gui.map;

import java.awt.event.HierarchyEvent;
import java.util.function.Consumer;
import javax.swing.Timer;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.map.MapSnapshot;
import org.sami.ui.map.MapView;
import org.sami.ui.value.MapMaker;

/** Makes further maps of the session, such as a decision's own: they show the same as the main one and refresh each second while they are visible. */
public final class SessionMaps implements MapMaker {
    private static final int REFRESH_MS = 1000;

    private final OperatorContext context;
    private final Consumer<MapView> baseMaps;

    /**
     * Maps of a session.
     *
     * @param baseMaps gives a map the base maps that the main one shows now
     */
    public SessionMaps(OperatorContext context, Consumer<MapView> baseMaps) {
        this.context = context;
        this.baseMaps = baseMaps;
    }

    @Override
    public MapView make() {
        MapView view = new MapView();
        MapFeed feed = new MapFeed(context, view.layers());
        feed.show(snapshot());
        baseMaps.accept(view);
        MapFeed.bounds(snapshot()).ifPresent(view::fit);
        Timer refresh = new Timer(REFRESH_MS, event -> {
            feed.show(snapshot());
            baseMaps.accept(view);
        });
        view.addHierarchyListener(event -> {
            if ((event.getChangeFlags() & HierarchyEvent.SHOWING_CHANGED) != 0) {
                if (view.isShowing()) {
                    refresh.start();
                } else {
                    refresh.stop();
                }
            }
        });
        return view;
    }

    private MapSnapshot snapshot() {
        return context.models().map().snapshot();
    }
}
