package org.sami.picture.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.sami.palette.IdentityMark;
import org.sami.palette.ProxyMarks;
import org.sami.palette.SemanticColor;
import org.sami.palette.Theme;
import org.sami.picture.Canvas;
import org.sami.picture.NetFonts;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.drawing.NetLayout;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Token;

class NetPainterTest {
    private static final Plan PLAN = ShippedPlans.plan("clv");
    private static final NetDrawing DRAWING = NetLayout.given(PLAN, ShippedPlans.VOCABULARY, NetFonts::width);
    private static final String PLACE = PLAN.places().get(1).id();

    private final Noted canvas = new Noted();
    private final ProxyMarks marks = new ProxyMarks();

    /** What was painted in which colour. */
    private static final class Noted implements Canvas {
        private record Filled(Shape shape, Color color) {}

        private final List<Filled> filled = new ArrayList<>();
        private final List<BasicStroke> strokes = new ArrayList<>();
        private final List<String> texts = new ArrayList<>();

        @Override
        public void fill(Shape shape, Color color) {
            filled.add(new Filled(shape, color));
        }

        @Override
        public void draw(Shape shape, Color color, BasicStroke stroke) {
            strokes.add(stroke);
        }

        @Override
        public void text(String text, Font font, Color color, double x, double baseline) {
            texts.add(text);
        }

        private Color at(Vertex vertex) {
            return filled.stream()
                    .filter(each -> each.shape() instanceof Ellipse2D
                            && each.shape()
                                    .contains(
                                            vertex.centre().x(), vertex.centre().y()))
                    .findFirst()
                    .orElseThrow()
                    .color();
        }
    }

    private void paint(Theme theme, NetMarking marking, double zoom) {
        NetFigure net = new NetFigure(NetScene.of(DRAWING), marking, NetBadges.NONE, NetLight.NONE);
        NetPainter.paint(canvas, theme, marks, net, new NetSight(DRAWING.bounds(), zoom, 1));
    }

    @ParameterizedTest
    @EnumSource
    void aThemeSaysInWhichColours(Theme theme) {
        paint(theme, NetMarking.EMPTY, 1);

        Vertex plain = DRAWING.vertices().stream()
                .filter(vertex -> vertex.id().equals(PLACE))
                .findFirst()
                .orElseThrow();
        assertThat(canvas.at(plain)).isEqualTo(SemanticColor.NET_PLACE_FILL.in(theme));
        assertThat(canvas.filled).extracting(Noted.Filled::color).contains(SemanticColor.NET_TRANSITION.in(theme));
    }

    @ParameterizedTest
    @EnumSource
    void aProxysTokenHasTheProxysColourAndShape(Theme theme) {
        marks.give("anna");
        for (int i = 1; i < 12; i++) {
            marks.give("boat " + i);
        }
        marks.give("bert");

        List<Token> tokens = List.of(new Token.Proxy("anna"), new Token.Proxy("bert"));
        paint(theme, new NetMarking(Map.of(PLACE, tokens), Set.of(), Map.of()), 1);

        Color orange = new IdentityMark(0).color(theme);
        List<Shape> chips = canvas.filled.stream()
                .filter(each -> each.color().equals(orange))
                .map(Noted.Filled::shape)
                .toList();
        assertThat(chips).as("the thirteenth has the first's colour").hasSize(2);
        assertThat(chips.get(0)).isInstanceOf(Ellipse2D.class);
        assertThat(chips.get(1)).isNotInstanceOf(Ellipse2D.class);
    }

    @Test
    void aNetThatIsTooSmallForItsWordsHasNamesAndLinesThatAreSeen() {
        paint(Theme.LIGHT, NetMarking.EMPTY, 0.2);

        assertThat(canvas.texts).isNotEmpty().doesNotContain("Take All Relevant");
        assertThat(canvas.strokes)
                .isNotEmpty()
                .allSatisfy(stroke -> assertThat(stroke.getLineWidth() * 0.2).isGreaterThanOrEqualTo(1.19));
        assertThat(NetStrokes.at(1).thin().getLineWidth()).isEqualTo(1.4f);
        assertThat(NetStrokes.at(0.2).rim().getLineWidth())
                .isGreaterThan(NetStrokes.at(0.2).thin().getLineWidth());
    }
}
