package org.sami.crw.gui;

import java.util.List;
import java.util.Optional;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.DefaultAnswers;
import org.sami.crw.decision.SimulatedOperator;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionOperator;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.GeoPoint;

/** Gives each mission an equal share of the boats, never ends one, and leaves all other questions to the simulated operator. */
final class SharingOperator implements SessionOperator {
    private static final double AREA_M = 400;

    private final Session session;
    private final int missions;
    private final SimulatedOperator simulated;

    SharingOperator(Session session, int missions, GeoPoint pier) {
        this.session = session;
        this.missions = missions;
        simulated = new SimulatedOperator(
                session.setup().vocabulary(), new DefaultAnswers(pier, pier, AREA_M, 1, 1), AnswersFile.EMPTY);
    }

    @Override
    public String name() {
        return "sharing operator";
    }

    @Override
    public void asked(Asked asked) {
        Question question = asked.decision().question();
        if (question instanceof Question.Approve) {
            return;
        }
        Optional<Answer> answer = question instanceof Question.ChooseProxies choice
                ? Optional.of(new Answer.Proxies(
                        share(choice.proxies(), asked.decision().mission())))
                : simulated.answer(asked.decision(), asked.plan()).result();
        answer.ifPresent(given -> session.answer(asked.decision().id(), given, name()));
    }

    private List<String> share(List<String> boats, long mission) {
        int each = boats.size() / missions;
        int first = (int) ((mission - 1) % missions) * each;
        return boats.subList(first, first + each);
    }

    @Override
    public void settled(long decision, Optional<Answer> answer, String by) {
        // it forgets what it has answered
    }
}
