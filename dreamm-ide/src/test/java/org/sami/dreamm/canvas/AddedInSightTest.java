package org.sami.dreamm.canvas;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.awt.event.KeyListener;
import java.awt.geom.Point2D;
import java.util.LinkedHashSet;
import java.util.Set;
import javax.swing.JMenuItem;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.sami.dreamm.OnEventThread;
import org.sami.dreamm.palette.PalettePanel;
import org.sami.dreamm.palette.PaletteSteps;
import org.sami.picture.NetFonts;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.model.Plan;
import org.sami.ui.check.Layout;
import org.sami.ui.net.NetKey;

/** What is added comes into sight, wherever the author has looked before. */
@ExtendWith(OnEventThread.class)
class AddedInSightTest {
    private final EditorScene scene = EditorScene.of("clv");

    @AfterEach
    void close() {
        scene.close();
    }

    private void lookElsewhere() {
        scene.view.net().press(NetKey.ACTUAL_SIZE);
        for (int i = 0; i < 40; i++) {
            scene.view.net().press(NetKey.UP);
        }
    }

    private void pressEnterInPalette(String words) {
        PalettePanel palette = new PalettePanel(scene.context);
        JTextField search =
                Layout.find(palette, "palette-search", JTextField.class).orElseThrow();
        search.setText(words);
        for (KeyListener keys : search.getKeyListeners()) {
            keys.keyPressed(
                    new KeyEvent(search, KeyEvent.KEY_PRESSED, 0, 0, KeyEvent.VK_ENTER, KeyEvent.CHAR_UNDEFINED));
        }
    }

    private Set<String> newSince(Plan before) {
        Set<String> made = new LinkedHashSet<>();
        scene.plan().places().forEach(place -> made.add(place.id()));
        scene.plan().transitions().forEach(transition -> made.add(transition.id()));
        before.places().forEach(place -> made.remove(place.id()));
        before.transitions().forEach(transition -> made.remove(transition.id()));
        return made;
    }

    private boolean isInSight(String id) {
        DrawingBox box = scene.vertex(id).box();
        Point2D first = scene.view.net().pixel(box.x(), box.y());
        Point2D last = scene.view.net().pixel(box.maxX(), box.maxY());
        return first.getX() >= 0
                && first.getY() >= 0
                && last.getX() <= scene.view.net().canvas().getWidth()
                && last.getY() <= scene.view.net().canvas().getHeight();
    }

    @Test
    void eventOfThePaletteIsBroughtIntoSightWithAllThatComesWithIt() {
        Plan before = scene.plan();
        scene.context.editor().select(Set.of("finished"));
        lookElsewhere();

        pressEnterInPalette("goto point");

        assertThat(newSince(before)).isNotEmpty().allMatch(this::isInSight);
        assertThat(scene.context.editor().selection()).isNotEmpty().allMatch(this::isInSight);
    }

    @Test
    void blankVertexOfThePaletteIsBroughtIntoSight() {
        Plan before = scene.plan();
        lookElsewhere();

        pressEnterInPalette("blank place");

        assertThat(newSince(before)).hasSize(1).allMatch(this::isInSight);
    }

    @Test
    void stepOfTheAppendMenuIsBroughtIntoSight() {
        ShownNet net = new ShownNet(scene.context.vocabulary(), NetFonts::width);
        net.show(scene.context.editor().plan());
        scene.context
                .document()
                .addListener(change -> net.show(scene.context.editor().plan()));
        NetActions actions = new NetActions(scene.context, scene.view.net(), net);
        actions.setAppendChoices(new PaletteSteps(scene.context));
        Plan before = scene.plan();
        lookElsewhere();

        Layout.find(actions.appendMenu("execute"), "net-append-1", JMenuItem.class)
                .orElseThrow()
                .doClick();

        assertThat(newSince(before)).isNotEmpty().allMatch(this::isInSight);
    }

    @Test
    void pasteThatDoesNotFitIsShownSmaller() {
        scene.run("net-select-all");
        scene.run("net-copy");
        Plan before = scene.plan();
        scene.view.net().press(NetKey.ACTUAL_SIZE);
        for (int i = 0; i < 3; i++) {
            scene.view.net().press(NetKey.ZOOM_IN);
        }

        scene.run("net-paste");

        assertThat(newSince(before)).isNotEmpty().allMatch(this::isInSight);
    }

    @Test
    void nothingMovesWhereAllIsInSight() {
        scene.context.editor().select(Set.of("finished"));
        scene.view.net().press(NetKey.FIT);
        for (int i = 0; i < 2; i++) {
            scene.view.net().press(NetKey.ZOOM_OUT);
        }
        Point2D at = scene.view.net().pixel(0, 0);
        double zoom = scene.view.net().zoom();
        Plan before = scene.plan();

        pressEnterInPalette("blank transition");

        assertThat(newSince(before)).hasSize(1).allMatch(this::isInSight);
        assertThat(scene.view.net().pixel(0, 0)).isEqualTo(at);
        assertThat(scene.view.net().zoom()).isEqualTo(zoom);
    }
}
