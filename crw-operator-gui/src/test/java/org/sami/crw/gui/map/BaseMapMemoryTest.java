package org.sami.crw.gui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Supplier;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.MenuElement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.ui.EventThread;
import org.sami.ui.map.BaseMapState;
import org.sami.ui.map.MapView;
import org.sami.ui.window.WindowSettings;

/** Base maps outlive their window, and are taken off and put on in the menu of layers. */
class BaseMapMemoryTest {
    private static final int WITHIN_S = 300;

    @TempDir
    private Path folder;

    private MapView window() {
        return onEventThread(() -> {
            MapView view = new MapView();
            BaseMapMemory.of(view, new WindowSettings(folder.resolve("window.properties")));
            return view;
        });
    }

    private Path land(String name) throws Exception {
        return Files.writeString(
                folder.resolve(name), "{\"type\": \"LineString\", \"coordinates\": [[10.7, 45.7], [10.8, 45.7]]}");
    }

    @Test
    void theNextWindowHasTheSameBaseMapsOnAndOff() throws Exception {
        Path shore = land("shore = \u00e4.geojson");
        Path rocks = land("rocks.geojson");
        MapView first = window();
        open(first, shore);
        open(first, rocks);
        onEventThread(() -> {
            first.setBaseMap(rocks, false);
            first.close();
            return first;
        });

        MapView next = window();

        assertThat(onEventThread(next::baseMaps))
                .extracting(BaseMapState::file, BaseMapState::on)
                .containsExactly(
                        org.assertj.core.groups.Tuple.tuple(shore, true),
                        org.assertj.core.groups.Tuple.tuple(rocks, false));
        until(() -> next.layers().find("base-" + shore.getFileName()).isPresent());
        onEventThread(() -> {
            next.close();
            return next;
        });
    }

    @Test
    void aBaseMapOnAStickThatIsNotThereIsRememberedAllTheSame() throws Exception {
        Path stick = land("stick.geojson");
        MapView first = window();
        open(first, stick);
        Files.delete(stick);
        MapView second = window();
        until(() -> !second.baseMaps().get(0).problem().isEmpty());
        land("stick.geojson");

        MapView third = window();

        until(() -> third.layers().find("base-stick.geojson").isPresent());
        onEventThread(() -> {
            List.of(first, second, third).forEach(MapView::close);
            return third;
        });
    }

    @Test
    void theMenuTakesABaseMapOffAndTheCommandAllOfThem() throws Exception {
        Path shore = land("<html><b>shore.geojson");
        MapView view = window();
        open(view, shore);
        BaseMapMenu menu = onEventThread(() -> new BaseMapMenu(view));
        JMenuItem item = onEventThread(() -> item(menu));
        assertThat(item.getText()).isEqualTo("base map <html><b>shore.geojson");

        onEventThread(() -> {
            item.doClick(0);
            return item;
        });
        assertThat(onEventThread(view::baseMaps)).extracting(BaseMapState::on).containsExactly(false);

        for (boolean on : new boolean[] {true, false, true}) {
            onEventThread(() -> {
                menu.toggle().run();
                return menu;
            });
            assertThat(onEventThread(view::baseMaps))
                    .extracting(BaseMapState::on)
                    .containsExactly(on);
        }
        onEventThread(() -> {
            view.close();
            return view;
        });
    }

    private static JMenuItem item(BaseMapMenu menu) {
        JPopupMenu popup = new JPopupMenu();
        menu.addTo(popup);
        for (MenuElement element : popup.getSubElements()) {
            if (element instanceof JMenuItem item
                    && String.valueOf(item.getName()).startsWith("base-map-")) {
                return item;
            }
        }
        throw new IllegalStateException("the menu has no base map");
    }

    private static void open(MapView view, Path file) {
        onEventThread(() -> {
            view.openBaseMap(file);
            return view;
        });
        until(() -> view.baseMaps().stream().anyMatch(map -> map.file().equals(file)));
    }

    private static void until(Supplier<Boolean> so) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(WITHIN_S);
        while (!onEventThread(so)) {
            assertThat(System.nanoTime()).isLessThan(end);
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(5));
        }
    }

    private static <T> T onEventThread(Supplier<T> work) {
        return EventThread.isCurrent() ? work.get() : EventThread.get(work);
    }
}
