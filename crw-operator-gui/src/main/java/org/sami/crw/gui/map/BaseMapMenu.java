package org.sami.crw.gui.map;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import org.sami.ui.command.Command;
import org.sami.ui.map.BaseMapState;
import org.sami.ui.map.MapListener;
import org.sami.ui.map.MapView;

/** The base maps of a map in its menu of layers: each is taken off and put on again, and taken off the list. */
final class BaseMapMenu {
    private final MapView view;
    private final Command toggle;
    private List<Path> taken = List.of();

    BaseMapMenu(MapView view) {
        this.view = view;
        toggle = new Command("map-base-toggle", "Base maps on or off", this::toggleAll)
                .withKey("alt shift N")
                .withIcon("layers")
                .unless(() -> view.baseMaps().isEmpty() ? Optional.of("no base map was opened") : Optional.empty());
        view.addMapListener(new MapListener() {
            @Override
            public void baseMapsChanged() {
                toggle.refresh();
            }
        });
    }

    /** The command that takes off all base maps, and puts those on again that it took off. */
    Command toggle() {
        return toggle;
    }

    private void toggleAll() {
        List<BaseMapState> all = view.baseMaps();
        List<Path> on =
                all.stream().filter(BaseMapState::on).map(BaseMapState::file).toList();
        if (on.isEmpty()) {
            List<Path> again = taken.isEmpty() ? List.of(all.get(all.size() - 1).file()) : taken;
            again.forEach(file -> view.setBaseMap(file, true));
        } else {
            on.forEach(file -> view.setBaseMap(file, false));
            taken = on;
        }
    }

    /** Adds what there is to a menu; nothing where no base map was opened. */
    void addTo(JPopupMenu menu) {
        List<BaseMapState> all = view.baseMaps();
        if (all.isEmpty()) {
            return;
        }
        menu.addSeparator();
        JMenu forget = new JMenu("Take off the list");
        forget.setName("forget-base-map");
        for (BaseMapState state : all) {
            JCheckBoxMenuItem item = new JCheckBoxMenuItem(
                    "base map " + state.name(), state.on() && state.problem().isEmpty());
            item.setName("base-map-" + state.file().getFileName());
            item.setToolTipText(state.problem().isEmpty() ? state.file().toString() : state.problem());
            item.addActionListener(e -> view.setBaseMap(state.file(), item.isSelected()));
            menu.add(item);
            JMenuItem gone = new JMenuItem(state.name());
            gone.setName("forget-" + state.file().getFileName());
            gone.setToolTipText(state.file().toString());
            gone.addActionListener(e -> view.forgetBaseMap(state.file()));
            forget.add(gone);
        }
        menu.add(forget);
    }
}
