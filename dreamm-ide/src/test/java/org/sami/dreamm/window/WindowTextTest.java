package org.sami.dreamm.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.dreamm.OnEventThread;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.context.LibraryProject;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.palette.Theme;
import org.sami.spn.json.DomainLibrary;
import org.sami.ui.check.Layout;
import org.sami.ui.check.ShownColors;
import org.sami.ui.check.TextFit;
import org.sami.ui.dock.DockPanel;
import org.sami.ui.dock.PanelSizes;
import org.sami.ui.look.Look;

/** All panels of the window as large as they are in it at first, laid out in memory: no text is cut. */
@Tag("long")
@Isolated("the look is one for all windows of a process")
@ExtendWith(OnEventThread.class)
class WindowTextTest {
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final int MENUS_AND_STATUS = 90;

    private DreammContext context;
    private RunParts run;

    static Stream<Arguments> windows() {
        return Stream.of(Theme.values())
                .flatMap(theme -> Stream.of(100, 150, 200)
                        .flatMap(scale -> Stream.of(new Dimension(1280, 800), new Dimension(1600, 1000))
                                .map(size -> Arguments.of(theme, scale, size))));
    }

    /** Opens a plan of the library. Gives all panels of its window. */
    private List<DockPanel> open() {
        context = new DreammContext(
                LIBRARY,
                new ProjectDocument(LIBRARY.vocabulary(), LibraryProject.of(LIBRARY), Optional.empty()),
                Profile.ALL);
        context.editor().open("station-keep");
        EditCommands.addTo(context);
        run = new RunParts(context);
        return new DreammPanels(context, run).all();
    }

    @AfterEach
    void close() {
        run.close();
        context.close();
        Look.apply(Theme.LIGHT, 100);
    }

    @ParameterizedTest
    @MethodSource("windows")
    void noTextOfAPanelIsCut(Theme theme, int scale, Dimension size) {
        Look.apply(theme, scale);
        List<DockPanel> panels = open();
        Dimension area = new Dimension(size.width, size.height - Look.px(MENUS_AND_STATUS));
        Map<String, Dimension> sizes = PanelSizes.of(DreammPanels.FIRST.fitting(area), area);

        List<String> faults = new ArrayList<>();
        context.commands().get("try-start").run();
        for (Set<String> selection : List.of(Set.<String>of(), Set.of("assemble"), Set.of("go.arrived"))) {
            context.editor().select(selection);
            for (DockPanel panel : panels) {
                Dimension room = sizes.get(panel.getPersistentID());
                Layout.layOut(panel, room.width, room.height);
                TextFit.faults(panel).stream()
                        .map(fault ->
                                panel.getPersistentID() + " of " + room.width + " x " + room.height + ": " + fault)
                        .filter(fault -> !faults.contains(fault))
                        .forEach(faults::add);
            }
        }

        assertThat(faults).isEmpty();
    }

    @Test
    void allLettersGrowWithTheScaleWhileTheWindowIsOpen() {
        Look.apply(Theme.LIGHT, 100);
        List<DockPanel> panels = open();
        context.editor().select(Set.of("assemble"));
        context.commands().get("try-start").run();
        Map<Component, Float> before = new LinkedHashMap<>();
        panels.forEach(panel -> collectSizes(panel, before));

        Look.apply(Theme.LIGHT, 150);
        panels.forEach(SwingUtilities::updateComponentTreeUI);

        assertThat(before).hasSizeGreaterThan(20);
        assertThat(before.entrySet())
                .filteredOn(one -> one.getKey().getFont().getSize2D() < 1.4 * one.getValue())
                .extracting(one -> one.getKey().getClass().getSimpleName() + " "
                        + one.getKey().getName() + " "
                        + one.getKey().getAccessibleContext().getAccessibleName())
                .isEmpty();
    }

    @Test
    void allColoursAreThoseOfTheLookAlsoWhenItChangesWhileTheWindowIsOpen() {
        Look.apply(Theme.DARK, 100);
        List<String> wanted = coloursOfAll(open());
        run.close();
        context.close();
        Look.apply(Theme.LIGHT, 100);
        List<DockPanel> panels = open();
        assertThat(coloursOfAll(panels)).isNotEqualTo(wanted);

        Look.apply(Theme.DARK, 100);
        panels.forEach(SwingUtilities::updateComponentTreeUI);

        assertThat(coloursOfAll(panels)).hasSizeGreaterThan(100).containsExactlyInAnyOrderElementsOf(wanted);
    }

    private List<String> coloursOfAll(List<DockPanel> panels) {
        context.editor().select(Set.of("assemble"));
        return panels.stream().flatMap(panel -> ShownColors.of(panel).stream()).toList();
    }

    private static void collectSizes(Container root, Map<Component, Float> sizes) {
        for (Component part : root.getComponents()) {
            boolean says = part instanceof JLabel label
                    ? label.getText() != null && !label.getText().isBlank()
                    : part instanceof AbstractButton button
                            ? button.getText() != null && !button.getText().isBlank()
                            : part instanceof JTextComponent;
            if (says) {
                sizes.put(part, part.getFont().getSize2D());
            }
            if (part instanceof Container container) {
                collectSizes(container, sizes);
            }
        }
    }
}
