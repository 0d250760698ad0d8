package org.sami.picture.net;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Shape;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import java.util.Optional;
import org.sami.palette.IdentityMark;
import org.sami.palette.ProxyMarks;
import org.sami.palette.SemanticColor;
import org.sami.palette.Theme;
import org.sami.picture.NetFonts;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.drawing.TextStyle;
import org.sami.spn.protocol.Token;

/**
 * Paints the tokens of a place inside of it: a proxy's mark, a small square for a task in its proxy's colour, a dot for the generic
 * token. More than five are a number.
 */
final class TokenPainter {
    private static final int MOST = 5;
    private static final double CHIP = 11.5;
    private static final double DOT = 8;
    private static final double TOKEN_SPACING = 7.5;
    private static final double[][][] PLACES = {
        {{0, 0}},
        {{-1, 0}, {1, 0}},
        {{0, -1.1}, {-1, 0.8}, {1, 0.8}},
        {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}},
        {{-1.15, -1.15}, {1.15, -1.15}, {-1.15, 1.15}, {1.15, 1.15}, {0, 0}}
    };
    private static final BasicStroke LINE = new BasicStroke(1.2f);
    private static final BasicStroke HEAVY = new BasicStroke(2);

    private final Pen pen;
    private final ProxyMarks marks;
    private final NetMarking marking;

    TokenPainter(Pen pen, ProxyMarks marks, NetMarking marking) {
        this.pen = pen;
        this.marks = marks;
        this.marking = marking;
    }

    void paint(Vertex place) {
        double x = place.centre().x();
        double y = place.centre().y();
        List<Token> tokens = marking.at(place.id());
        if (tokens.size() > MOST) {
            count(x, y, tokens.size());
        } else if (tokens.isEmpty()) {
            if (marking.visitedByNobody().contains(place.id())) {
                pen.draw(Pen.circle(x, y, DOT / 2), SemanticColor.NET_ACTIVE, LINE);
            }
        } else {
            double[][] at = PLACES[tokens.size() - 1];
            for (int i = 0; i < at.length; i++) {
                token(x + at[i][0] * TOKEN_SPACING, y + at[i][1] * TOKEN_SPACING, tokens.get(i));
            }
        }
    }

    private void token(double x, double y, Token token) {
        Optional<IdentityMark> mark = marking.proxyOf(token).map(marks::of);
        Color text = pen.color(SemanticColor.TEXT);
        Color color = mark.map(each -> each.color(pen.theme())).orElse(text);
        if (token instanceof Token.Proxy) {
            Shape shape = mark.orElseThrow().shape().around(x, y, CHIP);
            pen.canvas().fillAndDraw(shape, color, text, pen.theme() == Theme.SUN ? HEAVY : LINE);
        } else if (token instanceof Token.Task) {
            double side = CHIP - 2;
            Rectangle2D square = new Rectangle2D.Double(x - side / 2, y - side / 2, side, side);
            if (mark.isPresent()) {
                pen.canvas().fill(square, color);
            }
            pen.canvas().draw(square, text, LINE);
        } else {
            pen.canvas().fill(Pen.circle(x, y, DOT / 2), color);
        }
    }

    private void count(double x, double y, int count) {
        String text = String.valueOf(count);
        double width = NetFonts.width(text, TextStyle.NAME) + 10;
        double height = TextStyle.NAME.size() + 5;
        pen.fill(
                new RoundRectangle2D.Double(x - width / 2, y - height / 2, width, height, height, height),
                SemanticColor.NET_ACTIVE);
        pen.canvas()
                .text(
                        text,
                        NetFonts.of(TextStyle.NAME),
                        pen.color(SemanticColor.ON_ACCENT),
                        x - width / 2 + 5,
                        y + TextStyle.NAME.size() * 0.36);
    }
}
