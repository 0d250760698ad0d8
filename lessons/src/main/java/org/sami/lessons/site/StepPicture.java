package org.sami.lessons.site;

import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.lessons.course.Picture;
import org.sami.lessons.course.TokensAt;
import org.sami.palette.ProxyMarks;
import org.sami.palette.Theme;
import org.sami.picture.NetFonts;
import org.sami.picture.SvgCanvas;
import org.sami.picture.net.NetBadges;
import org.sami.picture.net.NetFigure;
import org.sami.picture.net.NetLight;
import org.sami.picture.net.NetMarking;
import org.sami.picture.net.NetPainter;
import org.sami.picture.net.NetScene;
import org.sami.picture.net.NetSight;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetLayout;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.vocabulary.Vocabulary;

/** Draws the picture of a step as SVG: the plan's net, what is pointed out in it, and its tokens. */
final class StepPicture {
    private static final double MARGIN = 24;

    private StepPicture() {}

    /** An SVG document. */
    static String svg(Plan plan, Vocabulary vocabulary, Picture picture) {
        NetDrawing drawing = NetLayout.given(plan, vocabulary, NetFonts::width);
        NetFigure figure = new NetFigure(
                NetScene.of(drawing),
                new NetMarking(tokens(picture.tokens()), Set.of(), Map.of()),
                NetBadges.NONE,
                new NetLight(Set.copyOf(picture.mark()), Set.of(), transition -> 0, Map.of()));
        DrawingBox net = drawing.bounds();
        Rectangle2D area = new Rectangle2D.Double(
                net.x() - MARGIN,
                net.y() - MARGIN,
                Math.ceil(net.width() + 2 * MARGIN),
                Math.ceil(net.height() + 2 * MARGIN));
        String title = picture.caption().isEmpty() ? plan.name() : picture.caption();
        return SvgCanvas.document(
                title,
                area,
                canvas -> NetPainter.paint(canvas, Theme.LIGHT, new ProxyMarks(), figure, new NetSight(net, 1, 1)));
    }

    private static Map<String, List<Token>> tokens(List<TokensAt> all) {
        Map<String, List<Token>> tokens = new LinkedHashMap<>();
        for (TokensAt at : all) {
            List<Token> here = new ArrayList<>();
            for (int i = 0; i < at.generic(); i++) {
                here.add(Token.GENERIC);
            }
            at.robots().forEach(robot -> here.add(new Token.Proxy(robot)));
            at.tasks().forEach(task -> here.add(new Token.Task(new TaskId(1, task))));
            tokens.put(at.place(), here);
        }
        return tokens;
    }
}
