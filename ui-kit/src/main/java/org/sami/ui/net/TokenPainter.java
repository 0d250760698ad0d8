package org.sami.ui.net;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import java.util.Optional;
import org.sami.palette.IdentityMark;
import org.sami.palette.IdentityMarks;
import org.sami.palette.SemanticColor;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.drawing.TextStyle;
import org.sami.spn.protocol.Token;
import org.sami.ui.look.MarkIcon;

/**
 * Paints the tokens of a place inside of it: a proxy's mark, a small square for a task in its proxy's colour, a dot for the generic
 * token. More than five are a number.
 */
final class TokenPainter {
    private static final int MOST = 5;
    private static final double CHIP = 11.5;
    private static final double DOT = 8;
    private static final double APART = 7.5;
    private static final double[][][] PLACES = {
        {{0, 0}},
        {{-1, 0}, {1, 0}},
        {{0, -1.1}, {-1, 0.8}, {1, 0.8}},
        {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}},
        {{-1.15, -1.15}, {1.15, -1.15}, {-1.15, 1.15}, {1.15, 1.15}, {0, 0}}
    };
    private static final BasicStroke LINE = new BasicStroke(1.2f);

    private final IdentityMarks marks;

    TokenPainter(IdentityMarks marks) {
        this.marks = marks;
    }

    void paint(Graphics2D g, Vertex place, NetMarking marking) {
        double x = place.centre().x();
        double y = place.centre().y();
        List<Token> tokens = marking.at(place.id());
        if (tokens.size() > MOST) {
            count(g, x, y, tokens.size());
        } else if (tokens.isEmpty()) {
            if (marking.visitedByNobody().contains(place.id())) {
                g.setStroke(LINE);
                g.setColor(SemanticColor.NET_ACTIVE.get());
                g.draw(new Ellipse2D.Double(x - DOT / 2, y - DOT / 2, DOT, DOT));
            }
        } else {
            double[][] at = PLACES[tokens.size() - 1];
            for (int i = 0; i < at.length; i++) {
                token(g, x + at[i][0] * APART, y + at[i][1] * APART, tokens.get(i), marking);
            }
        }
    }

    private void token(Graphics2D g, double x, double y, Token token, NetMarking marking) {
        Optional<IdentityMark> mark = marking.proxyOf(token).map(marks::of);
        if (token instanceof Token.Proxy) {
            MarkIcon.paint(g, mark.orElseThrow(), x, y, CHIP);
            return;
        }
        double side = token instanceof Token.Task ? CHIP - 2 : DOT;
        g.setColor(mark.map(IdentityMark::color).orElseGet(SemanticColor.TEXT::get));
        if (token instanceof Token.Task) {
            Rectangle2D square = new Rectangle2D.Double(x - side / 2, y - side / 2, side, side);
            if (mark.isPresent()) {
                g.fill(square);
            }
            g.setColor(SemanticColor.TEXT.get());
            g.setStroke(LINE);
            g.draw(square);
        } else {
            g.fill(new Ellipse2D.Double(x - side / 2, y - side / 2, side, side));
        }
    }

    private static void count(Graphics2D g, double x, double y, int count) {
        String text = String.valueOf(count);
        double width = NetFonts.width(text, TextStyle.NAME) + 10;
        double height = TextStyle.NAME.size() + 5;
        g.setColor(SemanticColor.NET_ACTIVE.get());
        g.fill(new RoundRectangle2D.Double(x - width / 2, y - height / 2, width, height, height, height));
        g.setColor(SemanticColor.ON_ACCENT.get());
        g.setFont(NetFonts.of(TextStyle.NAME));
        g.drawString(text, (float) (x - width / 2 + 5), (float) (y + TextStyle.NAME.size() * 0.36));
    }
}
