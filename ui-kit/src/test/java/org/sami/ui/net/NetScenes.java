package org.sami.ui.net;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.palette.ProxyMarks;
import org.sami.picture.net.NetMarking;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.vocabulary.Vocabulary;

/** Shipped plans in a view without a window. */
final class NetScenes {
    static final String CRW = "/org/sami/domain/crw";
    static final DomainLibrary LIBRARY = DomainLibrary.fromClassPath(CRW).orThrow();
    static final Vocabulary VOCABULARY = LIBRARY.vocabulary();

    private NetScenes() {}

    static Plan plan(String id) {
        return LIBRARY.plans().stream()
                .filter(plan -> plan.id().equals(id))
                .findFirst()
                .orElseThrow();
    }

    /** A view of a size that shows a plan. */
    static NetView view(Plan plan, int width, int height) {
        NetView view = new NetView(new ProxyMarks());
        view.setSize(width, height);
        view.doLayout();
        view.show(plan, VOCABULARY);
        return view;
    }

    /** None to eight tokens of all kinds in the places of a plan, in turn. */
    static NetMarking marking(Plan plan) {
        Map<String, List<Token>> tokens = new LinkedHashMap<>();
        TaskId task = new TaskId(1, "visit");
        for (int i = 0; i < plan.places().size(); i++) {
            List<Token> there = new ArrayList<>();
            for (int k = 0; k < i % 9; k++) {
                there.add(
                        k == 1
                                ? Token.GENERIC
                                : k == 3 ? new Token.Task(task) : new Token.Proxy("proxy-" + (i + k) % 14));
            }
            tokens.put(plan.places().get(i).id(), there);
        }
        return new NetMarking(tokens, Set.of(plan.places().get(0).id()), Map.of(task, "proxy-2"));
    }

    static BufferedImage paint(NetView view) {
        BufferedImage image = new BufferedImage(view.getWidth(), view.getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        view.paint(g);
        g.dispose();
        return image;
    }
}
