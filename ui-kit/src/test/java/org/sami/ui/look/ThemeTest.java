package org.sami.ui.look;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.palette.SemanticColor.ACCENT;
import static org.sami.palette.SemanticColor.BACKGROUND;
import static org.sami.palette.SemanticColor.CRITICAL;
import static org.sami.palette.SemanticColor.CRITICAL_FILL;
import static org.sami.palette.SemanticColor.MUTED;
import static org.sami.palette.SemanticColor.OK;
import static org.sami.palette.SemanticColor.ON_ACCENT;
import static org.sami.palette.SemanticColor.ON_CRITICAL;
import static org.sami.palette.SemanticColor.ON_SELECTION;
import static org.sami.palette.SemanticColor.ON_WARNING;
import static org.sami.palette.SemanticColor.SELECTION;
import static org.sami.palette.SemanticColor.SURFACE;
import static org.sami.palette.SemanticColor.SURFACE_RAISED;
import static org.sami.palette.SemanticColor.TEXT;
import static org.sami.palette.SemanticColor.WARNING;
import static org.sami.palette.SemanticColor.WARNING_FILL;

import java.awt.Color;
import java.util.List;
import java.util.Map;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.palette.Contrast;
import org.sami.palette.SemanticColor;
import org.sami.palette.Theme;

@Isolated("the look is one for all windows of a process")
class ThemeTest {
    private static final List<SemanticColor> WORDS = List.of(TEXT, MUTED, OK, WARNING, CRITICAL, ACCENT);
    private static final List<SemanticColor> SURFACES = List.of(BACKGROUND, SURFACE, SURFACE_RAISED);
    private static final Map<SemanticColor, SemanticColor> WORDS_ON_FILLS =
            Map.of(ON_ACCENT, ACCENT, ON_SELECTION, SELECTION, ON_WARNING, WARNING_FILL, ON_CRITICAL, CRITICAL_FILL);

    private static final List<SemanticColor> NET_MARKS = List.of(
            SemanticColor.NET_PLACE,
            SemanticColor.NET_TRANSITION,
            SemanticColor.NET_EDGE,
            SemanticColor.NET_START,
            SemanticColor.NET_END,
            SemanticColor.NET_RECOVERY,
            SemanticColor.NET_FIRING,
            SemanticColor.NET_ACTIVE);
    private static final List<SemanticColor> MAP_MARKS = List.of(
            SemanticColor.MAP_OUTLINE,
            SemanticColor.MAP_TEXT,
            SemanticColor.MAP_AREA,
            SemanticColor.MAP_NO_GO,
            SemanticColor.MAP_FENCE,
            SemanticColor.MAP_HIGHLIGHT);

    @AfterEach
    void backToTheFirst() {
        Look.apply(Theme.LIGHT, 100);
    }

    @ParameterizedTest
    @EnumSource(Theme.class)
    void wordsAreReadOnEverySurface(Theme theme) {
        double least = theme == Theme.SUN ? 7 : 4.5;
        for (SemanticColor surface : SURFACES) {
            assertThat(WORDS)
                    .allSatisfy(word -> assertThat(Contrast.of(word.in(theme), surface.in(theme)))
                            .as("%s on %s", word, surface)
                            .isGreaterThanOrEqualTo(least));
        }
        assertThat(WORDS_ON_FILLS)
                .allSatisfy((word, fill) -> assertThat(Contrast.of(word.in(theme), fill.in(theme)))
                        .as("%s on %s", word, fill)
                        .isGreaterThanOrEqualTo(least));
    }

    @ParameterizedTest
    @EnumSource(Theme.class)
    void marksAreSeenOnNetAndMap(Theme theme) {
        double least = theme == Theme.SUN ? 4.5 : 3;
        assertThat(NET_MARKS)
                .allSatisfy(mark -> assertThat(Contrast.of(mark.in(theme), SemanticColor.NET_CANVAS.in(theme)))
                        .as(mark.name())
                        .isGreaterThanOrEqualTo(least));
        assertThat(MAP_MARKS)
                .allSatisfy(mark -> assertThat(Contrast.of(mark.in(theme), SemanticColor.MAP_WATER.in(theme)))
                        .as(mark.name())
                        .isGreaterThanOrEqualTo(least));
    }

    @ParameterizedTest
    @EnumSource(Theme.class)
    void standardComponentsHaveTheColoursOfTheTheme(Theme theme) {
        Look.apply(theme, 100);

        assertThat(rgb("Panel.background")).isEqualTo(BACKGROUND.get());
        assertThat(rgb("Label.foreground")).isEqualTo(TEXT.get());
        assertThat(rgb("Table.background")).isEqualTo(SURFACE.get());
        assertThat(rgb("Table.selectionBackground")).isEqualTo(SELECTION.get());
        assertThat(rgb("Label.disabledForeground")).isEqualTo(SemanticColor.DISABLED.get());
    }

    @Test
    void everythingOfSunIsReadInTheSun() {
        Look.apply(Theme.SUN, 100);

        for (String kind : List.of(
                "Label",
                "Button",
                "TextField",
                "Table",
                "List",
                "Tree",
                "Menu",
                "MenuItem",
                "TableHeader",
                "ComboBox",
                "CheckBox",
                "RadioButton",
                "ToolTip",
                "TabbedPane",
                "TextArea",
                "Button.default")) {
            Color below = UIManager.getColor(kind + ".background");
            Color words = UIManager.getColor(kind + ".foreground");
            assertThat(Contrast.of(words, below)).as(kind).isGreaterThanOrEqualTo(7);
        }
        for (String grey : List.of(
                "Label.disabledForeground",
                "Button.disabledText",
                "MenuItem.disabledForeground",
                "MenuItem.acceleratorForeground",
                "TextField.placeholderForeground",
                "Component.borderColor",
                "TabbedPane.underlineColor",
                "TabbedPane.inactiveUnderlineColor")) {
            assertThat(Contrast.of(UIManager.getColor(grey), Color.WHITE))
                    .as(grey)
                    .isGreaterThanOrEqualTo(7);
        }
    }

    @ParameterizedTest
    @EnumSource(Theme.class)
    void buttonsAreReadInEveryState(Theme theme) {
        Look.apply(theme, 100);

        double least = theme == Theme.SUN ? 7 : 4.5;
        for (String kind : List.of("Button", "Button.default")) {
            for (String state : List.of("background", "focusedBackground", "hoverBackground", "pressedBackground")) {
                Color below = UIManager.getColor(kind + "." + state);
                Color words = UIManager.getColor(
                        kind + "." + state.replace("background", "foreground").replace("Background", "Foreground"));
                Color shown = words == null ? UIManager.getColor(kind + ".foreground") : words;
                if (below != null) {
                    assertThat(Contrast.of(shown, below)).as(kind + " " + state).isGreaterThanOrEqualTo(least);
                }
            }
        }
    }

    @ParameterizedTest
    @EnumSource(Theme.class)
    void theFocusOnTheDefaultButtonIsSeenBetweenItsGroundAndTheRing(Theme theme) {
        Look.apply(theme, 100);

        Color line = UIManager.getColor("Button.default.focusedBorderColor");
        assertThat(Contrast.of(line, UIManager.getColor("Button.default.background")))
                .isGreaterThanOrEqualTo(theme == Theme.SUN ? 4.5 : 3);
    }

    @ParameterizedTest
    @ValueSource(ints = {80, 100, 150, 200})
    void textGrowsWithTheScale(int percent) {
        Look.apply(Theme.LIGHT, percent);

        assertThat(new JLabel("x").getFont().getSize2D())
                .isCloseTo(Fonts.text().getSize2D(), org.assertj.core.data.Offset.offset(1.1f));
        assertThat(Fonts.display().getSize2D())
                .isCloseTo(24 * percent / 100f, org.assertj.core.data.Offset.offset(0.1f));
        assertThat(Look.px(40)).isEqualTo(40 * percent / 100);
    }

    @Test
    void textHasItsSizeAgainAfterAnotherScale() {
        Look.apply(Theme.LIGHT, 150);
        Look.apply(Theme.DARK, 100);

        assertThat(new JLabel("x").getFont().getSize2D()).isEqualTo(13);
    }

    @ParameterizedTest
    @ValueSource(ints = {100, 150, 200, 80})
    void distancesOfLayoutsGrowWithTheScale(int percent) {
        Look.apply(Theme.LIGHT, percent);
        JPanel panel = new JPanel(new MigLayout("insets 0", "[100!]"));
        panel.add(new JLabel("x"));

        assertThat(panel.getPreferredSize().width).isEqualTo(percent);
    }

    @Test
    void listenersHearOfEachChange() {
        int[] heard = {0};
        Runnable listener = () -> heard[0]++;
        Look.addListener(listener);

        Look.apply(Theme.DARK, 100);
        Look.apply(Theme.DARK, 125);
        Look.removeListener(listener);
        Look.apply(Theme.LIGHT, 100);

        assertThat(heard[0]).isEqualTo(2);
    }

    private static Color rgb(String key) {
        return new Color(UIManager.getColor(key).getRGB());
    }
}
